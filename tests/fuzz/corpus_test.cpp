// The inputs that fuzzing found worth keeping, through the same target without a fuzzer.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace foverig {
namespace {

namespace fs = std::filesystem;

TEST(RecordingCorpus, EveryInputGivesAnErrorOrAFileThatReadsBack) {
    int inputs = 0;
    for (const auto& file :
         fs::directory_iterator(fs::path(FOVERIG_SOURCE_DIR) / "tests/fuzz/corpus/recording")) {
        std::ifstream stream(file.path(), std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(stream), {});
        EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                         bytes.size()),
                  0)
            << file;
        ++inputs;
    }
    EXPECT_GT(inputs, 20);
}

}  // namespace
}  // namespace foverig
