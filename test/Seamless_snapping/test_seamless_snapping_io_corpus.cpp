// The files that a fuzzer has found to take different ways through the readers are read and
// written: see fuzzing/fuzz_files.cpp.

#include "fuzzing/check_file_text.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

int main()
{
  std::size_t number_of_files = 0, number_of_meshes = 0;
  for(const auto& entry : std::filesystem::directory_iterator("fuzzing/corpus")) {
    std::ifstream is(entry.path(), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(is), {});
    if(!CHECK(!text.empty()))
      continue;
    const std::size_t failed = checking::counts().failed;
    const unsigned char way = static_cast<unsigned char>(text[0]);
    number_of_meshes += check_file_text(text.substr(1), way % 2 == 0 ? File_format::OBJ
                                                                    : File_format::PLY,
                                        way % 4 >= 2) ? 1 : 0;
    ++number_of_files;
    if(checking::counts().failed != failed)
      std::cerr << "    " << entry.path() << std::endl;
  }
  std::cout << number_of_files << " files, " << number_of_meshes << " meshes" << std::endl;
  CHECK(number_of_files > 0 && number_of_meshes > 0 && number_of_meshes < number_of_files);
  return report_checks();
}
