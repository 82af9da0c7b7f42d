#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace foverig::metrics {

/// Calls work(y) for each row, on all threads.
template <class Work>
void for_rows(int rows, const Work& work) {
    tbb::parallel_for(tbb::blocked_range<int>(0, rows, 16), [&](const tbb::blocked_range<int>& r) {
        for (int y = r.begin(); y < r.end(); ++y) work(y);
    });
}

/// Sum of work(y) over the rows, added in their order: the same on any number of threads.
template <class Sum, class Work>
Sum sum_of_rows(int rows, const Work& work) {
    std::vector<Sum> of_row(static_cast<std::size_t>(rows));
    for_rows(rows, [&](int y) { of_row[static_cast<std::size_t>(y)] = work(y); });
    Sum sum{};
    for (const Sum& s : of_row) sum += s;
    return sum;
}

}  // namespace foverig::metrics
