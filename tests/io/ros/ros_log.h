// What a reader makes of a recording.
#pragma once
#include "../../shipped_datasets.h"
#include "../sample_logs.h"
#include "../temporary_folder.h"
#include "recording.h"

inline const std::filesystem::path kRecordings = ariadne::test::shippedDatasets() / "ros";

class RosLog : public TemporaryFolder {
 protected:
  static sample::Result readWith(const std::filesystem::path& path,
                                 const ariadne::io::RosOptions& ros) {
    ariadne::io::DatasetOptions options;
    options.ros = ros;
    return sample::read(path, options);
  }
  sample::Result read(const std::string& bytes, const ariadne::io::RosOptions& ros = {}) {
    ariadne::io::writeWhole(folder / "a.mcap", bytes);
    return readWith(folder / "a.mcap", ros);
  }
  sample::Result read(const recording::Mcap& file, const ariadne::io::RosOptions& ros = {}) {
    return read(file.bytes(), ros);
  }
};

/// Expects an error that holds all these parts.
inline void expectTold(const sample::Result& r, const std::vector<std::string>& parts) {
  EXPECT_FALSE(r.error.empty());
  for (const std::string& part : parts)
    EXPECT_NE(r.error.find(part), std::string::npos) << r.error << "\n  lacks: " << part;
}
