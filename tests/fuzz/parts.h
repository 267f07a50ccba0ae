// The readers one by one: each reads a file as our programs do.
#pragma once
#include <filesystem>

namespace ariadne::fuzz {

using Path = std::filesystem::path;

void readLog(const Path& file);
void readMetadata(const Path& file);
void readNewerObservation(const Path& file);
void readTum(const Path& file);
void readRelations(const Path& file);
void readWorld(const Path& file);
void readRosMap(const Path& file);
void readSimplemap(const Path& file);
void readPicture(const Path& file);
void readDrive(const Path& file);

void readSlamIni(const Path& file);
void readLogOrIni(const Path& file);
void readLoopIni(const Path& file);
void readExperimentIni(const Path& file);
void readSettings(const Path& file);
void readRequirement(const Path& file);

void readPlan(const Path& file);
void readResult(const Path& file);
void readJob(const Path& file);
void readJoblog(const Path& file);
void readCsv(const Path& file);
void readSteps(const Path& file);
void readFigures(const Path& file);

}  // namespace ariadne::fuzz
