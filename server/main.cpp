#include "server/commands.hpp"
#include "server/options.hpp"

#include <exception>
#include <iostream>
#include <variant>

int main(int argument_count, char** arguments) {
  namespace server = pentapost::server;
  try {
    const auto options = server::read_options(argument_count, arguments);
    if (const auto* code = std::get_if<server::ExitCode>(&options)) return *code;
    return std::visit([](const auto& command) { return run(command); },
                      std::get<server::Command>(options));
  } catch (const std::exception& exception) {
    std::cerr << "pentapost: " << exception.what() << '\n';
    return server::exit_defect;
  }
}
