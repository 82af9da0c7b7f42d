#pragma once
// Small matrices of fixed size, in double, for filters and least squares. Row by row; no blocking,
// no allocation.
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "devices/math.h"

namespace foverig {

template <std::size_t R, std::size_t C>
struct Matrix {
    std::array<double, R * C> values{};

    double& operator()(std::size_t r, std::size_t c) { return values[r * C + c]; }
    double operator()(std::size_t r, std::size_t c) const { return values[r * C + c]; }

    static Matrix identity() {
        Matrix m;
        for (std::size_t i = 0; i < R && i < C; ++i) m(i, i) = 1.0;
        return m;
    }
    /// Puts a 3x3 (columns first, as glm's) at row `r`, column `c`.
    void set_block(std::size_t r, std::size_t c, const dmat3& block) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) (*this)(r + i, c + k) = block[k][i];
        }
    }
    dmat3 block(std::size_t r, std::size_t c) const {
        dmat3 out(0.0);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) out[k][i] = (*this)(r + i, c + k);
        }
        return out;
    }
    Matrix& operator+=(const Matrix& other) {
        for (std::size_t i = 0; i < R * C; ++i) values[i] += other.values[i];
        return *this;
    }
    Matrix& operator*=(double scale) {
        for (double& v : values) v *= scale;
        return *this;
    }
};

template <std::size_t R, std::size_t K, std::size_t C>
Matrix<R, C> operator*(const Matrix<R, K>& a, const Matrix<K, C>& b) {
    Matrix<R, C> out;
    for (std::size_t r = 0; r < R; ++r) {
        for (std::size_t k = 0; k < K; ++k) {
            const double f = a(r, k);
            for (std::size_t c = 0; c < C; ++c) out(r, c) += f * b(k, c);
        }
    }
    return out;
}

template <std::size_t R, std::size_t C>
Matrix<C, R> transposed(const Matrix<R, C>& m) {
    Matrix<C, R> out;
    for (std::size_t r = 0; r < R; ++r) {
        for (std::size_t c = 0; c < C; ++c) out(c, r) = m(r, c);
    }
    return out;
}

/// Of a symmetric matrix, by Cholesky; nothing where it is not positive definite.
template <std::size_t N>
std::optional<Matrix<N, N>> inverse_spd(const Matrix<N, N>& m) {
    Matrix<N, N> low;
    for (std::size_t r = 0; r < N; ++r) {
        for (std::size_t c = 0; c <= r; ++c) {
            double sum = m(r, c);
            for (std::size_t k = 0; k < c; ++k) sum -= low(r, k) * low(c, k);
            if (r != c) {
                low(r, c) = sum / low(c, c);
            } else if (sum > 0.0 && std::isfinite(sum)) {
                low(r, r) = std::sqrt(sum);
            } else {
                return std::nullopt;
            }
        }
    }
    Matrix<N, N> inverse_low;  // L^-1, column by column
    for (std::size_t c = 0; c < N; ++c) {
        for (std::size_t r = c; r < N; ++r) {
            double sum = r == c ? 1.0 : 0.0;
            for (std::size_t k = c; k < r; ++k) sum -= low(r, k) * inverse_low(k, c);
            inverse_low(r, c) = sum / low(r, r);
        }
    }
    return transposed(inverse_low) * inverse_low;
}

/// The matrix of v x.
inline dmat3 cross_matrix(const dvec3& v) {
    return dmat3(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
}

}  // namespace foverig
