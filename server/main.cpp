#include "server/commands.hpp"
#include "server/options.hpp"

#include <exception>
#include <iostream>
#include <variant>

int main(int argument_count, char** arguments) {
  using namespace pentapost::server;
  try {
    const auto options = read_options(argument_count, arguments);
    if (const auto* code = std::get_if<ExitCode>(&options)) return *code;
    return std::visit([](const auto& command) { return run(command); }, std::get<Command>(options));
  } catch (const std::exception& exception) {
    std::cerr << "pentapost: " << exception.what() << '\n';
    return exit_defect;
  }
}
