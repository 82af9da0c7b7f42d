#include "devices/fusion/inertial_filter.h"

#include <cmath>

#include "devices/fusion/rotation.h"
#include "devices/head_geometry.h"

namespace foverig {
namespace {

constexpr dvec3 kGravityWorld_m_s2{0, -kGravity_m_s2, 0};

// One sigma of what is not known at the start.
constexpr double kStartPosition_m = 0.005, kStartVelocity_m_s = 0.3, kStartTurn_rad = 0.02;
constexpr double kStartAccelBias_m_s2 = 0.3, kStartGyroBias_rad_s = 0.02;

using State = InertialFilter::State;
using Covariance = InertialFilter::Covariance;

void set_diagonal(Covariance& m, std::size_t at, double sigma) {
    for (std::size_t i = at; i < at + 3; ++i) m(i, i) = sigma * sigma;
}

/// Rows of part `to` become `by` times rows of part `from`, plus `keep` times themselves.
void mix_rows(Covariance& m, std::size_t to, const dmat3& keep, std::size_t from, const dmat3& by) {
    for (std::size_t c = 0; c < 15; ++c) {
        const dvec3 old(m(to, c), m(to + 1, c), m(to + 2, c));
        const dvec3 other(m(from, c), m(from + 1, c), m(from + 2, c));
        const dvec3 now = keep * old + by * other;
        for (int i = 0; i < 3; ++i) m(to + i, c) = now[i];
    }
}

void make_symmetric(Covariance& m) {
    for (std::size_t r = 0; r < 15; ++r) {
        for (std::size_t c = 0; c < r; ++c) m(r, c) = m(c, r) = 0.5 * (m(r, c) + m(c, r));
    }
}

/// K = P H' S^-1 and what follows of it; `gain_rows` is P H'.
template <std::size_t N>
void correct(State& state, const Matrix<15, N>& gain_rows, const Matrix<N, N>& inverse_spread,
             const Matrix<N, 1>& surprise) {
    const Matrix<15, N> gain = gain_rows * inverse_spread;
    const Matrix<15, 1> step = gain * surprise;
    const Matrix<15, 15> known = gain * transposed(gain_rows);
    for (std::size_t i = 0; i < known.values.size(); ++i) {
        state.covariance.values[i] -= known.values[i];
    }
    make_symmetric(state.covariance);
    const auto part = [&](std::size_t at) {
        return dvec3(step(at, 0), step(at + 1, 0), step(at + 2, 0));
    };
    state.position_m += part(InertialFilter::kPosition);
    state.velocity_m_s += part(InertialFilter::kVelocity);
    state.world_from_body =
        glm::normalize(state.world_from_body * exp_map(part(InertialFilter::kTurn)));
    state.accel_bias_m_s2 += part(InertialFilter::kAccelBias);
    state.gyro_bias_rad_s += part(InertialFilter::kGyroBias);
}

}  // namespace

State InertialFilter::start(const RigidPose& world_from_body, const dvec3& velocity_m_s) {
    State state;
    state.position_m = world_from_body.translation_m;
    state.velocity_m_s = velocity_m_s;
    state.world_from_body = world_from_body.rotation;
    set_diagonal(state.covariance, kPosition, kStartPosition_m);
    set_diagonal(state.covariance, kVelocity, kStartVelocity_m_s);
    set_diagonal(state.covariance, kTurn, kStartTurn_rad);
    set_diagonal(state.covariance, kAccelBias, kStartAccelBias_m_s2);
    set_diagonal(state.covariance, kGyroBias, kStartGyroBias_rad_s);
    return state;
}

void InertialFilter::advance(State& s, const Inertial& before, const Inertial& after, double dt_s,
                             const InertialNoise& noise) {
    const dvec3 rate_before = before.gyro_rad_s - s.gyro_bias_rad_s;
    const dvec3 bias_after =
        s.gyro_bias_rad_s + after.bias_by_warmth_rad_s - before.bias_by_warmth_rad_s;
    const dvec3 rate_after = after.gyro_rad_s - bias_after;
    const dvec3 turn_rad = rotation_of_rates(rate_before, rate_after, dt_s);
    const dquat turned = glm::normalize(s.world_from_body * exp_map(turn_rad));
    const dvec3 force_before = before.accel_m_s2 - s.accel_bias_m_s2;
    const dvec3 force_after = after.accel_m_s2 - s.accel_bias_m_s2;
    const dvec3 acceleration_m_s2 =
        0.5 * (s.world_from_body * force_before + turned * force_after) + kGravityWorld_m_s2;

    // P = F P F' by rows, then by columns; the order reads each part before it is changed.
    const dmat3 one(1.0);
    const dmat3 rotation = glm::mat3_cast(s.world_from_body);
    const dmat3 by_turn = rotation * cross_matrix(0.5 * (force_before + force_after)) * -dt_s;
    const dmat3 turned_back = glm::mat3_cast(exp_map(-turn_rad));
    Covariance& p = s.covariance;
    for (int side = 0; side < 2; ++side) {
        mix_rows(p, kPosition, one, kVelocity, one * dt_s);
        mix_rows(p, kVelocity, one, kTurn, by_turn);
        mix_rows(p, kVelocity, one, kAccelBias, rotation * -dt_s);
        mix_rows(p, kTurn, turned_back, kGyroBias, one * -dt_s);
        p = transposed(p);
    }
    const double gyro = noise.gyro_rad_sqrt_s + noise.gyro_scale * glm::length(turn_rad) / dt_s;
    const auto add = [&](std::size_t at, double density) {
        for (std::size_t i = at; i < at + 3; ++i) p(i, i) += density * density * dt_s;
    };
    add(kVelocity, noise.accel_m_s_sqrt_s);
    add(kTurn, gyro);
    add(kAccelBias, noise.accel_walk_m_s2_sqrt_s);
    add(kGyroBias, noise.gyro_walk_rad_s_sqrt_s);

    s.position_m += dt_s * s.velocity_m_s + 0.5 * dt_s * dt_s * acceleration_m_s2;
    s.velocity_m_s += dt_s * acceleration_m_s2;
    s.world_from_body = turned;
    s.gyro_bias_rad_s = bias_after;
}

double InertialFilter::measure_pose(State& state, const RigidPose& measured,
                                    const Matrix<6, 6>& covariance, double gate) {
    const dvec3 turn = log_map(glm::conjugate(state.world_from_body) * measured.rotation);
    const dvec3 way = measured.translation_m - state.position_m;
    Matrix<6, 1> surprise;
    Matrix<15, 6> gain_rows;  // P H': columns of the turn, then of the position
    for (std::size_t i = 0; i < 3; ++i) {
        surprise(i, 0) = turn[static_cast<int>(i)];
        surprise(i + 3, 0) = way[static_cast<int>(i)];
        for (std::size_t r = 0; r < 15; ++r) {
            gain_rows(r, i) = state.covariance(r, kTurn + i);
            gain_rows(r, i + 3) = state.covariance(r, kPosition + i);
        }
    }
    Matrix<6, 6> spread = covariance;
    for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t i = 0; i < 3; ++i) {
            spread(i, c) += gain_rows(kTurn + i, c);
            spread(i + 3, c) += gain_rows(kPosition + i, c);
        }
    }
    const auto inverse = inverse_spd(spread);
    if (!inverse) return HUGE_VAL;
    const double distance2 = (transposed(surprise) * *inverse * surprise)(0, 0);
    if (!(distance2 <= gate)) return distance2;
    correct(state, gain_rows, *inverse, surprise);
    return distance2;
}

void InertialFilter::measure_rest(State& state, const dvec3& rate_rad_s, const dvec3& lever_m,
                                  double sigma_m_s) {
    // v + R (w x l) = 0, so that an error d of the turn enters by -R [w x l]x d.
    const dvec3 swing = glm::cross(rate_rad_s - state.gyro_bias_rad_s, lever_m);
    const dvec3 velocity = state.velocity_m_s + state.world_from_body * swing;
    const dmat3 by_turn = glm::mat3_cast(state.world_from_body) * -cross_matrix(swing);
    Matrix<15, 3> gain_rows;
    Matrix<3, 1> surprise;
    for (std::size_t i = 0; i < 3; ++i) {
        surprise(i, 0) = -velocity[static_cast<int>(i)];
        for (std::size_t r = 0; r < 15; ++r) {
            gain_rows(r, i) = state.covariance(r, kVelocity + i);
            for (std::size_t k = 0; k < 3; ++k) {
                gain_rows(r, i) += state.covariance(r, kTurn + k) *
                                   by_turn[static_cast<int>(k)][static_cast<int>(i)];
            }
        }
    }
    Matrix<3, 3> spread;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < 3; ++i) {
            spread(i, c) = gain_rows(kVelocity + i, c);
            for (std::size_t k = 0; k < 3; ++k) {
                spread(i, c) +=
                    by_turn[static_cast<int>(k)][static_cast<int>(i)] * gain_rows(kTurn + k, c);
            }
        }
        spread(c, c) += sigma_m_s * sigma_m_s;
    }
    if (const auto inverse = inverse_spd(spread)) correct(state, gain_rows, *inverse, surprise);
}

}  // namespace foverig
