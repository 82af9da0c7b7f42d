#pragma once
// A recorded head trajectory, played as a function of time.
#include <filesystem>
#include <vector>

#include "devices/result.h"
#include "simulators/motion/head_motion.h"

namespace foverig::motion {

/// Orientation by slerp between rows, so the angular velocity is constant from row to row.
/// Without positions the head turns about the neck; with them they follow a cubic Hermite curve.
/// Before the first row and after the last the head rests.
class RecordedHead final : public HeadMotion {
  public:
    struct Row {
        double t_s;
        dquat world_from_head;
        dvec3 position_m;
    };

    /// Columns t_s,qw,qx,qy,qz and perhaps x_m,y_m,z_m: world_from_head, and the point between the
    /// eyes. Quaternions must have length 1 within 1 %.
    static Result<RecordedHead> load(const std::filesystem::path& file);
    /// At least 2 rows with rising times and unit quaternions.
    RecordedHead(std::vector<Row> rows, bool has_position);

    HeadState at(double t_s) const override;
    double start_s() const { return rows_.front().t_s; }
    double end_s() const { return rows_.back().t_s; }

  private:
    HeadState rest(const Row& row) const;
    dvec3 row_velocity_m_s(std::size_t row) const;
    void move(HeadState& head, std::size_t segment, double t_s) const;

    std::vector<Row> rows_;
    std::vector<dvec3> segment_velocity_rad_s_;  ///< head frame, of the way from row i to i + 1
    bool has_position_;
};

}  // namespace foverig::motion
