#pragma once
#include <optional>
#include <vector>

#include "devices/math.h"

namespace foverig {

/// A row of a linear model: its terms, and the pair that they should add up to.
struct LinearRow {
    std::vector<double> terms;
    dvec2 wanted;
};

/// The coefficients, a pair for each term, with the least sum of squared errors, by Householder
/// reflections with column pivoting (Golub and Van Loan, Matrix Computations, 5.4). None where the
/// rows do not determine them: fewer than terms, or columns that are almost dependent.
std::optional<std::vector<dvec2>> solve_least_squares(std::vector<LinearRow> rows);

}  // namespace foverig
