// Lets libFuzzer invent files. The first byte of an input chooses the format and whether to weld.
// Built with clang:
//
//   clang++ -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined -Iinclude fuzz_files.cpp
//
// What it finds goes to corpus/, whose files test_seamless_snapping_io_corpus.cpp checks.

#include "check_file_text.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  check_file_text(text, data[0] % 2 == 0 ? File_format::OBJ : File_format::PLY, data[0] % 4 >= 2);
  if(checking::counts().failed > 0)
    std::abort();
  return 0;
}
