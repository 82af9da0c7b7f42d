#include "bench/stream_triad.h"

#include <algorithm>
#include <chrono>

#include "renderer/buffer.h"

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace foverig::bench {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 15U;  ///< elements a task

void triad(const double* b, const double* c, double* a, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0 * c[i];
}

/// Stores that do not read the line first.
void triad_non_temporal(const double* b, const double* c, double* a, std::size_t n) {
#if defined(__AVX__)
    const __m256d s = _mm256_set1_pd(3.0);
    for (std::size_t i = 0; i + 4 <= n; i += 4)
        _mm256_stream_pd(
            a + i, _mm256_add_pd(_mm256_load_pd(b + i), _mm256_mul_pd(s, _mm256_load_pd(c + i))));
    _mm_sfence();
#else
    triad(b, c, a, n);
#endif
}

template <class Body>
double best_gb_s(CpuBackend& backend, std::size_t n, int repetitions, const Body& body) {
    double best = 0.0;
    for (int r = 0; r < repetitions; ++r) {
        const auto start = std::chrono::steady_clock::now();
        backend.for_tiles(static_cast<int>(n / kBlock), [&](Lane&, int, int block) {
            body(static_cast<std::size_t>(block) * kBlock);
        });
        const double s =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        best = std::max(best, static_cast<double>(n) * 24.0e-9 / s);
    }
    return best;
}

}  // namespace

TriadRates stream_triad(CpuBackend& backend, std::size_t bytes, int repetitions) {
    const std::size_t n = bytes / sizeof(double) / kBlock * kBlock;
    MemoryCount memory;
    Buffer<double> a(memory, n);
    Buffer<double> b(memory, n);
    Buffer<double> c(memory, n);
    TriadRates rates;
    rates.plain_gb_s = best_gb_s(backend, n, repetitions, [&](std::size_t at) {
        triad(b.data() + at, c.data() + at, a.data() + at, kBlock);
    });
    rates.non_temporal_gb_s = best_gb_s(backend, n, repetitions, [&](std::size_t at) {
        triad_non_temporal(b.data() + at, c.data() + at, a.data() + at, kBlock);
    });
    return rates;
}

}  // namespace foverig::bench
