#include "dataset_app.h"

#include <functional>
#include <ostream>

#include "ariadne/core/error.h"
#include "command_line.h"
#include "commands.h"
#include "ros_arguments.h"
#include "run_program.h"
#include "simulate_options.h"

namespace ariadne {
namespace {

constexpr const char* kAbout =
    "Looks into datasets of 2D laser and odometry, converts them, and simulates new ones.\n"
    "Reads MRPT rawlogs (both forms) and CARMEN logs, gzip or not, and ROS recordings (.bag, "
    ".db3,\n"
    ".mcap, or a folder of them), told apart by content.";

constexpr const char* kExamples =
    "Examples:\n"
    "  ariadne-dataset info run.rawlog\n"
    "  ariadne-dataset info intel.clf.gz --json\n"
    "  ariadne-dataset import intel.clf.gz intel.rawlog\n"
    "  ariadne-dataset import drive.bag drive.rawlog --laser /scan --laser-pose '0.2 0 0'\n"
    "  ariadne-dataset export run.rawlog run.log.gz\n"
    "  ariadne-dataset noise corrected.log noisy.rawlog --rot-rot 0.1 --seed 7\n"
    "  ariadne-dataset simulate nested.world nested.path nested.rawlog --laps 6\n"
    "  ariadne-dataset world nested.world nested.png --path nested.path\n"
    "  ariadne-dataset world --random office --seed 7 office7.world office7.png\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use.";

constexpr const char* kNoiseFooter =
    "Each odometry increment gets Gaussian noise with\n"
    "  sigma of heading = rot-rot * |net turn| + rot-trans * distance\n"
    "  sigma of x and y = trans-trans * distance + trans-rot * |net turn|\n"
    "Writes OUT, a rawlog, and OUT.truth.tum, the poses of the robot before the noise.\n"
    "Example: ariadne-dataset noise corrected.log noisy.rawlog --rot-trans 0.02 --seed 7";

constexpr const char* kExportFooter =
    "ODOM and ROBOTLASER1 lines lose least: start angle, resolution and maximum range are kept,\n"
    "ranges with all digits. FLASER lines are for older programs and fit only 180 or 100 degrees\n"
    "of a SICK. Lost either way: the laser's height and label.\n"
    "Example: ariadne-dataset export run.rawlog run.log.gz";

class CommandLine {
 public:
  CommandLine() : app_(kAbout, "ariadne-dataset") {
    app_.footer(kExamples);
    app_.require_subcommand(1);
    CLI::App* info = add("info", "What is in a log, and whether it can be mapped", showInfo);
    info->add_flag("--json", args_.json, "as JSON");
    info->footer("Example: ariadne-dataset info run.rawlog --json");
    CLI::App* to_rawlog = add("import", "Any log to a rawlog of actions and frames", importLog);
    addOutput(to_rawlog, "rawlog to write");
    to_rawlog->footer("Example: ariadne-dataset import intel.clf.gz intel.rawlog");
    CLI::App* to_carmen = add("export", "Any log to a CARMEN log", exportLog);
    addOutput(to_carmen, "CARMEN log to write, compressed if it ends in .gz");
    to_carmen->add_flag_callback(
        "--flaser", [this] { args_.carmen_laser = io::CarmenLaser::flaser; },
        "FLASER lines instead of ROBOTLASER1");
    to_carmen->footer(kExportFooter);
    CLI::App* noise =
        add("noise", "Noise for a log's odometry; the clean poses are kept", addNoise);
    addOutput(noise, "rawlog to write");
    noise->add_option("--rot-rot", args_.noise.rot_rot, "rad of heading per rad turned")
        ->capture_default_str();
    noise->add_option("--rot-trans", args_.noise.rot_trans, "rad of heading per m")
        ->capture_default_str();
    noise->add_option("--trans-trans", args_.noise.trans_trans, "m of place per m")
        ->capture_default_str();
    noise->add_option("--trans-rot", args_.noise.trans_rot, "m of place per rad turned")
        ->capture_default_str();
    noise->add_option("--seed", args_.seed, "same seed, same noise")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);  // else -1 would be 2^64 - 1
    noise
        ->add_option("--restamp", args_.restamp_s,
                     "stamps this many seconds apart, for logs whose own are useless")
        ->check(CLI::Range(1e-4, 1e4));
    noise->footer(kNoiseFooter);
    addSimulation();
  }

  int run(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
    if (!app::parseCommandLine(app_, args, out)) return 0;
    command_(out, err);
    out.flush();
    if (!out) throw core::Error("cannot write to the standard output");
    return 0;
  }

 private:
  using Command = void (*)(const DatasetArguments&, std::ostream&, std::ostream&);

  CLI::App* add(const char* name, const char* about, Command command) {
    CLI::App* sub = app_.add_subcommand(name, about);
    sub->add_option("IN", args_.in, "log to read")->required();
    sub->add_option("--laser", args_.dataset.laser_label,
                    "label of the laser, where there are several; of a ROS recording its topic");
    sub->add_option("--field-of-view", args_.dataset.field_of_view_deg,
                    "degrees that the laser's beams span, for a CARMEN log that does not say it")
        ->check(CLI::Range(1.0, 360.0));
    sub->add_option("--max-range", args_.dataset.max_range_m,
                    "readings at or over this are no return, m; 0: told from the log");
    sub->add_option("--min-range", args_.dataset.min_range_m, "readings under this are left out, m")
        ->capture_default_str();
    addRosOptions(*sub, args_.dataset.ros);
    sub->callback([this, command] {
      command_ = [this, command](auto& out, auto& err) { command(args_, out, err); };
    });
    return sub;
  }
  void addSimulation() {
    declareSimulate(app_, simulate_)->callback([this] {
      command_ = [this](auto& out, auto& err) { simulate(simulate_, out, err); };
    });
    declareWorld(app_, simulate_)->callback([this] {
      command_ = [this](auto& out, auto& err) { drawWorld(simulate_, out, err); };
    });
  }
  void addOutput(CLI::App* sub, const char* about) {
    sub->add_option("OUT", args_.out, about)->required();
    sub->add_flag("-w,--overwrite", args_.overwrite, "replace what is there");
  }

  CLI::App app_;
  DatasetArguments args_;
  SimulateArguments simulate_;
  std::function<void(std::ostream&, std::ostream&)> command_;
};

}  // namespace

int runDatasetApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram("ariadne-dataset", err, [&] { return CommandLine().run(args, out, err); });
}

}  // namespace ariadne
