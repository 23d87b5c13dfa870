#pragma once

#include "server/options.hpp"

namespace pentapost::server {

ExitCode run(const ServeOptions& options);
ExitCode run(const PostFileOptions& options);
ExitCode run(const AnalyseFileOptions& options);
ExitCode run(const ReorientFileOptions& options);
ExitCode run(const CompareFileOptions& options);
ExitCode run(const MachinesOptions& options);
ExitCode run(const DialectsOptions& options);
ExitCode run(const VersionOptions& options);

}  // namespace pentapost::server
