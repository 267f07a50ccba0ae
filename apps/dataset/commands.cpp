#include "commands.h"

#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/tum.h"
#include "dataset_info.h"
#include "overwrite.h"
#include "progress.h"
#include "run_program.h"

namespace ariadne {
namespace {

namespace fs = std::filesystem;

std::string readingOf(const DatasetArguments& args) {
  return "reading " + args.in.filename().string();
}

/// Opens the input and lets `write` have its steps one by one.
template <class Write>
void convert(const DatasetArguments& args, std::ostream& out, std::ostream& err, Write write) {
  refuseToOverwrite(args.out, args.overwrite);
  std::unique_ptr<io::StepSource> steps;
  {
    app::Progress progress(err, app::progressStyle(false, err));
    const std::string what = readingOf(args);
    io::DatasetOptions options = args.dataset;
    double looked_through = 0;  // of the whole work
    options.goes_on = [&](double share) {
      progress.tell(what, looked_through = share / 3);
      return true;
    };
    steps = io::openDataset(args.in, options);
    const std::size_t count = write([&] {
      progress.tell(what, looked_through + (1 - looked_through) * steps->fraction());
      return steps->next();
    });
    progress.finish();
    out << fmt::format("{}: {} steps\n", args.out.string(), count);
  }
  app::warn(err, "ariadne-dataset", steps->warnings());
}

void restamp(models::SensorStep& step, double time_s) {
  step.time_s = time_s;
  step.scan->timestamp = mrpt::Clock::fromDouble(time_s);
}

}  // namespace

void showInfo(const DatasetArguments& args, std::ostream& out, std::ostream& err) {
  const DatasetInfo info = [&] {
    app::Progress progress(err, app::progressStyle(false, err));
    return collectInfo(args.in, args.dataset,
                       [&](double done) { progress.tell(readingOf(args), done); });
  }();
  out << (args.json ? infoAsJson(info) : infoAsText(info));
}

void importLog(const DatasetArguments& args, std::ostream& out, std::ostream& err) {
  convert(args, out, err,
          [&](const io::NextStep& next) { return io::writeRawlog(args.out, next); });
}

void exportLog(const DatasetArguments& args, std::ostream& out, std::ostream& err) {
  convert(args, out, err, [&](const io::NextStep& next) {
    return io::writeCarmen(args.out, next, args.carmen_laser);
  });
}

void addNoise(const DatasetArguments& args, std::ostream& out, std::ostream& err) {
  validate(args.noise);
  fs::path truth_path = args.out;
  truth_path += ".truth.tum";
  refuseToOverwrite(truth_path, args.overwrite);
  geometry::Trajectory truth;
  io::NoisyOdometry odometry(args.noise, args.seed);
  convert(args, out, err, [&](const io::NextStep& next) {
    return io::writeRawlog(args.out, [&] {
      auto step = next();
      if (step) {
        if (args.restamp_s > 0) restamp(*step, args.restamp_s * static_cast<double>(truth.size()));
        truth.push_back({step->time_s, step->odom_from_robot});
        step->odom_from_robot = odometry.add(step->odom_from_robot);
      }
      return step;
    });
  });
  const auto& n = args.noise;
  io::writeTum(
      truth_path, truth,
      {"poses of the robot before motion noise was added, in the frame of the log's odometry",
       fmt::format("from {} by ariadne-dataset noise --rot-rot {} --rot-trans {} "
                   "--trans-trans {} --trans-rot {} --seed {}",
                   args.in.filename().string(), n.rot_rot, n.rot_trans, n.trans_trans, n.trans_rot,
                   args.seed)});
  out << fmt::format("{}: {} clean poses\n", truth_path.string(), truth.size());
}

}  // namespace ariadne
