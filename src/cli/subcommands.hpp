// One function per subcommand, one file each. Each adds its arguments and what happens then.
#pragma once
#include <CLI/CLI.hpp>

namespace bozzetto::cli {

void addCheck(CLI::App& app);
void addExport(CLI::App& app);
void addHistory(CLI::App& app);
void addImport(CLI::App& app);
void addInfo(CLI::App& app);
void addRecover(CLI::App& app);
void addRender(CLI::App& app);
void addReplay(CLI::App& app);
void addTool(CLI::App& app);
/// Of `bozzetto tool`, which is long.
void addToolMake(CLI::App& tool);

}  // namespace bozzetto::cli
