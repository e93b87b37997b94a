// SPDX-License-Identifier: GPL-3.0-or-later
// Many command lines of the program in one process: loading its libraries takes longer than a
// small scene. Reads lines "folder<TAB>argument<TAB>argument..." and answers each with a line
// "exit code, bytes of standard output, bytes of standard error" and these bytes.
#include <filesystem>
#include <iostream>
#include <mpi.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

int
hybrid_main(int argc, char **argv); // main() of src/main.cc, renamed by CMakeLists.txt

namespace
{
  std::vector<std::string> split(const std::string &line)
  {
    std::vector<std::string> words(1);
    for (const char c : line)
      if (c == '\t')
        words.emplace_back();
      else
        words.back() += c;
    return words;
  }

  /// What is written to a stream while this lives.
  class Capture
  {
  public:
    explicit Capture(std::ostream &captured)
      : stream(captured)
      , earlier(captured.rdbuf(text.rdbuf()))
    {}

    ~Capture()
    {
      stream.rdbuf(earlier);
    }

    std::ostringstream text;

  private:
    std::ostream         &stream;
    std::streambuf *const earlier;
  };

  std::string answer(std::vector<std::string> words)
  {
    std::filesystem::current_path(words[0]);
    words[0] = "hybrid";
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);

    const Capture     out(std::cout), error(std::cerr);
    const int         code     = hybrid_main(words.size(), argv.data());
    const std::string out_text = out.text.str(), error_text = error.text.str();
    return std::to_string(code) + " " + std::to_string(out_text.size()) + " " +
           std::to_string(error_text.size()) + "\n" + out_text + error_text;
  }
} // namespace

int
main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  std::string line;
  while (std::getline(std::cin, line))
    std::cout << answer(split(line)) << std::flush;
  MPI_Finalize();
}
