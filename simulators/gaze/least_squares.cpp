#include "simulators/gaze/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace foverig {
namespace {

constexpr double kSmallestPivot = 1e-6;  // of the largest one

double squared_norm_below(const std::vector<LinearRow>& rows, std::size_t first, std::size_t term) {
    double sum = 0.0;
    for (std::size_t i = first; i < rows.size(); ++i)
        sum += rows[i].terms[term] * rows[i].terms[term];
    return sum;
}

/// Swaps the column with the most left in it to `k`.
void choose_pivot(std::vector<LinearRow>& rows, std::vector<std::size_t>& order, std::size_t k) {
    std::size_t best = k;
    double most = squared_norm_below(rows, k, k);
    for (std::size_t j = k + 1; j < order.size(); ++j) {
        const double norm = squared_norm_below(rows, k, j);
        if (norm > most) {
            most = norm;
            best = j;
        }
    }
    if (best == k) return;
    for (LinearRow& row : rows) std::swap(row.terms[k], row.terms[best]);
    std::swap(order[k], order[best]);
}

/// Reflects column k, from row k down, onto its first element; and all that lies right of it.
void reflect(std::vector<LinearRow>& rows, std::size_t k) {
    const std::size_t terms = rows.front().terms.size();
    const double norm = std::sqrt(squared_norm_below(rows, k, k));
    const double first = rows[k].terms[k];
    const double pivot = first > 0.0 ? -norm : norm;
    std::vector<double> v(rows.size() - k);
    for (std::size_t i = k; i < rows.size(); ++i) v[i - k] = rows[i].terms[k];
    v[0] -= pivot;
    const double vv = std::inner_product(v.begin(), v.end(), v.begin(), 0.0);
    if (vv == 0.0) return;
    for (std::size_t j = k; j < terms; ++j) {
        double along = 0.0;
        for (std::size_t i = k; i < rows.size(); ++i) along += v[i - k] * rows[i].terms[j];
        for (std::size_t i = k; i < rows.size(); ++i)
            rows[i].terms[j] -= 2.0 * along / vv * v[i - k];
    }
    dvec2 along(0.0);
    for (std::size_t i = k; i < rows.size(); ++i) along += v[i - k] * rows[i].wanted;
    for (std::size_t i = k; i < rows.size(); ++i) rows[i].wanted -= 2.0 / vv * v[i - k] * along;
}

}  // namespace

std::optional<std::vector<dvec2>> solve_least_squares(std::vector<LinearRow> rows) {
    if (rows.empty() || rows.size() < rows.front().terms.size()) return std::nullopt;
    const std::size_t terms = rows.front().terms.size();
    std::vector<std::size_t> order(terms);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = 0; k < terms; ++k) {
        choose_pivot(rows, order, k);
        reflect(rows, k);
        if (!(std::abs(rows[k].terms[k]) > kSmallestPivot * std::abs(rows[0].terms[0])))
            return std::nullopt;
    }
    std::vector<dvec2> coefficients(terms);
    for (std::size_t k = terms; k-- > 0;) {
        dvec2 left = rows[k].wanted;
        for (std::size_t j = k + 1; j < terms; ++j)
            left -= rows[k].terms[j] * coefficients[order[j]];
        coefficients[order[k]] = left / rows[k].terms[k];
    }
    return coefficients;
}

}  // namespace foverig
