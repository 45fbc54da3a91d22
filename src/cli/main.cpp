// bozzetto: the command line. Exit codes: 0 done, 1 the world was at fault (one line on standard
// error), 2 the command line was.
#include <csignal>
#include <cstdio>
#include <new>

#include "bozzetto/base/error.hpp"
#include "bozzetto/ui/window.hpp"
#include "cli/subcommands.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Sculpts volumetric virtual clay.", "bozzetto");
  app.set_version_flag("--version", BOZZETTO_VERSION);
  app.require_subcommand(0, 1);
  app.failure_message(CLI::FailureMessage::simple);
  bozzetto::cli::addImport(app);
  bozzetto::cli::addReplay(app);
  bozzetto::cli::addExport(app);
  bozzetto::cli::addRender(app);
  bozzetto::cli::addInfo(app);
  bozzetto::cli::addCheck(app);
  bozzetto::cli::addHistory(app);
  bozzetto::cli::addRecover(app);
  bozzetto::cli::addTool(app);
  bozzetto::WindowOptions window;
  app.add_option("scene", window.scene, "Opens the window: on a scene, or on a new ball of clay");
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) bozzetto::runWindow(window);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
}

int complain(const char* text) {
  std::fprintf(stderr, "bozzetto: %s\n", text);  // says nothing where nobody reads
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  // A full pipe or a file size limit is an error to report, not a reason to die.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
