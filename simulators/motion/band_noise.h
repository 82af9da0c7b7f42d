#pragma once
// Band-limited noise as a pure function of time: sines of hashed phase whose rate is flat between
// two frequencies.
#include <vector>

#include "simulators/motion/jet.h"
#include "simulators/motion/random.h"

namespace foverig::motion {

class BandNoise {
  public:
    /// `rate_rms`: root mean square of the derivative, per second.
    BandNoise(const Draws& draws, double low_hz, double high_hz, double rate_rms, int sines);

    Jet at(double t_s) const;

  private:
    struct Sine {
        double omega_rad_s;
        double phase_rad;
        double amplitude;
    };
    std::vector<Sine> sines_;
};

}  // namespace foverig::motion
