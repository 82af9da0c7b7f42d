// The inputs that fuzzing found worth keeping, through the same target without a fuzzer.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace foverig {

int fuzz_streams(const std::uint8_t* data, std::size_t size);
int fuzz_jpeg(const std::uint8_t* data, std::size_t size);
int fuzz_calibration(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

/// Returns how many there are.
template <class Target>
int run_corpus(const char* folder, const Target& target) {
    int inputs = 0;
    for (const auto& file :
         fs::directory_iterator(fs::path(FOVERIG_SOURCE_DIR) / "tests/fuzz/corpus" / folder)) {
        std::ifstream stream(file.path(), std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(stream), {});
        EXPECT_EQ(target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0)
            << file;
        ++inputs;
    }
    return inputs;
}

TEST(RecordingCorpus, EveryInputGivesAnErrorOrAFileThatReadsBack) {
    EXPECT_GT(run_corpus("recording", LLVMFuzzerTestOneInput), 20);
}

TEST(StreamsCorpus, EveryMangledStreamGivesNumbersOrIsRefused) {
    EXPECT_GT(run_corpus("streams", fuzz_streams), 10);
}

TEST(JpegCorpus, EveryFrameGivesAWholePictureOrIsRefused) {
    EXPECT_GT(run_corpus("jpeg", fuzz_jpeg), 10);
}

TEST(CalibrationCorpus, EveryFileGivesACalibrationOrIsRefused) {
    EXPECT_GT(run_corpus("calibration", fuzz_calibration), 10);
}

}  // namespace
}  // namespace foverig
