#include "simulators/gaze/calibration_map.h"

#include <algorithm>
#include <cmath>

#include "simulators/gaze/least_squares.h"

namespace foverig {
namespace {

using Terms = std::array<double, CalibrationMap::kTerms>;

Terms terms_of(const dvec2& u) {
    const double x = u.x, y = u.y;
    return {1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

std::size_t terms_for(int points) {
    switch (points) {
        case 1:
            return 1;
        case 5:
            return 3;
        case 9:
            return 6;
        default:
            return CalibrationMap::kTerms;
    }
}

/// Offset, gain and turn: the correction is a + b u in complex numbers.
std::optional<std::array<dvec2, 3>> fit_similarity(std::span<const dvec2> u,
                                                   std::span<const dvec2> wanted_deg) {
    dvec2 mean_u(0.0), mean_deg(0.0);
    const auto count = static_cast<double>(u.size());
    for (std::size_t i = 0; i < u.size(); ++i) {
        mean_u += u[i] / count;
        mean_deg += wanted_deg[i] / count;
    }
    dvec2 b(0.0);
    double spread = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const dvec2 du = u[i] - mean_u, dw = wanted_deg[i] - mean_deg;
        b += dvec2(du.x * dw.x + du.y * dw.y, du.x * dw.y - du.y * dw.x);
        spread += glm::dot(du, du);
    }
    if (!(spread > 1e-6)) return std::nullopt;
    b /= spread;
    const dvec2 along_x = b, along_y(-b.y, b.x);
    return std::array{mean_deg - mean_u.x * along_x - mean_u.y * along_y, along_x, along_y};
}

}  // namespace

std::optional<CalibrationMap> CalibrationMap::fit(int points, std::span<const dvec2> measured_deg,
                                                  std::span<const dvec2> wanted_deg) {
    if (measured_deg.empty() || measured_deg.size() != wanted_deg.size()) return std::nullopt;
    CalibrationMap map;
    for (const dvec2& at_deg : measured_deg)
        map.middle_deg_ += at_deg / static_cast<double>(measured_deg.size());
    for (const dvec2& at_deg : measured_deg)
        map.reach_deg_ = std::max(map.reach_deg_, glm::distance(at_deg, map.middle_deg_));

    std::vector<dvec2> u, corrections_deg;
    for (std::size_t i = 0; i < measured_deg.size(); ++i) {
        u.push_back((measured_deg[i] - map.middle_deg_) / map.reach_deg_);
        corrections_deg.push_back(wanted_deg[i] - measured_deg[i]);
    }
    if (points == 3) {
        const auto similarity = fit_similarity(u, corrections_deg);
        if (!similarity) return std::nullopt;
        std::copy(similarity->begin(), similarity->end(), map.coefficients_.begin());
        return map;
    }
    std::vector<LinearRow> rows;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const Terms terms = terms_of(u[i]);
        const auto used = static_cast<std::ptrdiff_t>(terms_for(points));
        rows.push_back({{terms.begin(), terms.begin() + used}, corrections_deg[i]});
    }
    const auto coefficients = solve_least_squares(std::move(rows));
    if (!coefficients) return std::nullopt;
    std::copy(coefficients->begin(), coefficients->end(), map.coefficients_.begin());
    return map;
}

dvec2 CalibrationMap::corrected_deg(const dvec2& measured_deg) const {
    const Terms terms = terms_of((measured_deg - middle_deg_) / reach_deg_);
    dvec2 corrected_deg = measured_deg;
    for (std::size_t i = 0; i < kTerms; ++i) corrected_deg += terms[i] * coefficients_[i];
    return corrected_deg;
}

std::array<std::byte, CalibrationMap::kBytes> CalibrationMap::encode() const {
    std::array<std::byte, kBytes> bytes{};
    std::size_t at = 0;
    const auto write = [&](double value) {
        write_u64(bytes, at, std::bit_cast<std::uint64_t>(value));
        at += 8;
    };
    write(middle_deg_.x);
    write(middle_deg_.y);
    write(reach_deg_);
    for (const dvec2& c : coefficients_) {
        write(c.x);
        write(c.y);
    }
    return bytes;
}

std::optional<CalibrationMap> CalibrationMap::decode(std::span<const std::byte, kBytes> bytes) {
    std::size_t at = 0;
    bool sane = true;
    const auto read = [&] {
        const auto value = std::bit_cast<double>(read_u64(bytes, at));
        at += 8;
        sane = sane && std::isfinite(value);
        return value;
    };
    const auto pair = [&] {
        const double x = read();
        return dvec2(x, read());
    };
    CalibrationMap map;
    map.middle_deg_ = pair();
    map.reach_deg_ = read();
    for (dvec2& c : map.coefficients_) c = pair();
    if (!sane || !(map.reach_deg_ > 0.0)) return std::nullopt;
    return map;
}

}  // namespace foverig
