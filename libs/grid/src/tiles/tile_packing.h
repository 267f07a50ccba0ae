// Between a packed tile and its 1024 bytes of log odds, for what works cell by cell.
#pragma once
#include "ariadne/grid/tiles/evidence_plane.h"

namespace ariadne::grid {

void unpack(const EvidenceTile& tile, const FreeCounts& counts, EvidencePlane::Cells& cells);
EvidenceTileRef pack(const EvidencePlane::Cells& cells, const FreeCounts& counts);

}  // namespace ariadne::grid
