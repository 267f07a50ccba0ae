#include "ariadne/loops/places/place_graph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>

#include "ariadne/geometry/pose.h"
#include "ariadne/grid/queries/line_of_sight.h"

namespace ariadne::loops {
namespace {

using mrpt::math::TPoint2D;

struct Near {
  double distance_m;
  std::uint32_t place;
  bool operator<(const Near& o) const {
    return distance_m != o.distance_m ? distance_m < o.distance_m : place < o.place;
  }
};

/// Places within range_m, nearest first.
std::vector<Near> placesNear(const SharedList<Place>& places, const TPoint2D& p, double range_m) {
  std::vector<Near> near;
  const double range2 = range_m * range_m;
  std::uint32_t i = 0;
  places.forEach([&](const Place& place) {
    const double dx = place.position.x - p.x;
    const double dy = place.position.y - p.y;
    if (dx * dx + dy * dy <= range2) near.push_back({geometry::distance(place.position, p), i});
    ++i;
  });
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace

void PlaceGraph::make(const TPoint2D& position) {
  places_.push_back({position, static_cast<std::uint32_t>(visits_.size())});
}

bool PlaceGraph::joined(std::uint32_t a, std::uint32_t b) const {
  bool found = false;
  edges_.forEach([&](const Edge& e) { found |= (e.a == a && e.b == b) || (e.a == b && e.b == a); });
  return found;
}

void PlaceGraph::arriveAt(std::uint32_t place, double length_m) {
  if (visits_.empty() || visits_.back().place == place) return;
  const std::uint32_t from = visits_.back().place;
  if (!joined(from, place))
    edges_.push_back(
        {from, place, static_cast<float>(length_m), static_cast<std::uint32_t>(visits_.size())});
}

bool PlaceGraph::observesAny(const TPoint2D& position, const grid::OccupancyGrid& map,
                             double range_m) const {
  if (visits_.empty()) return false;
  const auto observes = [&](const Place& p) {
    return geometry::distance(p.position, position) <= range_m &&
           grid::inSight(map, position, p.position);
  };
  if (observes(places_[visits_.back().place])) return true;  // mostly
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (observes(places_[i])) return true;
  return false;
}

void PlaceGraph::extend(const TPoint2D& position, const grid::OccupancyGrid& map,
                        const PlaceParams& params) {
  const double travelled =
      visits_.empty()
          ? 0
          : visits_.back().stub_m + geometry::distance(visits_.back().position, position);
  for (const Near& near : placesNear(places_, position, params.visit_radius_m)) {
    if (!grid::inSight(map, position, places_[near.place].position)) continue;
    arriveAt(near.place, travelled + near.distance_m);
    visits_.push_back({near.place, true, static_cast<float>(near.distance_m), position});
    return;
  }
  if (travelled < params.place_spacing_m && observesAny(position, map, params.place_range_m)) {
    visits_.push_back({visits_.back().place, false, static_cast<float>(travelled), position});
    return;
  }
  const auto made = static_cast<std::uint32_t>(places_.size());
  arriveAt(made, travelled);
  make(position);
  visits_.push_back({made, true, 0, position});
}

void PlaceGraph::close(std::uint32_t place) {
  const std::uint32_t here = visits_.back().place;
  if (here == place || joined(here, place)) return;
  edges_.push_back(
      {here, place,
       static_cast<float>(geometry::distance(places_[here].position, places_[place].position)),
       static_cast<std::uint32_t>(visits_.size() - 1)});
}

PlaceGraph PlaceGraph::asOf(std::size_t step) const {
  if (step >= visits_.size()) throw std::out_of_range("PlaceGraph::asOf: a step not yet taken");
  PlaceGraph past = *this;
  past.visits_.truncate(step + 1);
  std::size_t places = places_.size();
  while (places > 0 && places_[places - 1].step > step) --places;
  past.places_.truncate(places);
  std::size_t edges = edges_.size();
  while (edges > 0 && edges_[edges - 1].step > step) --edges;
  past.edges_.truncate(edges);
  return past;
}

void PlaceGraph::attach(const PlaceGraph& other, const std::vector<TPoint2D>& positions) {
  const std::size_t first = visits_.size();
  if (positions.size() + first != other.visits_.size())
    throw std::invalid_argument("PlaceGraph::attach: a position for each further update");
  std::size_t earlier = 0;  // places of `other` that were made before
  while (earlier < other.places_.size() && other.places_[earlier].step < first) ++earlier;
  const auto shift = static_cast<std::uint32_t>(places_.size() - earlier);
  const auto mine = [&](std::uint32_t place) {
    if (place >= earlier) return place + shift;
    return visits_[other.places_[place].step].place;  // where this particle was at that time
  };
  for (std::size_t i = earlier; i < other.places_.size(); ++i)
    places_.push_back({positions[other.places_[i].step - first], other.places_[i].step});
  other.edges_.forEach([&](const Edge& e) {
    if (e.step >= first && mine(e.a) != mine(e.b))
      edges_.push_back({mine(e.a), mine(e.b), e.length_m, e.step});
  });
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Visit& v = other.visits_[first + k];
    visits_.push_back({mine(v.place), v.inside, v.stub_m, positions[k]});
  }
}

// Dijkstra; MRPT's CDijkstra looks for the next node by a walk over all of them in a std::map.
std::vector<double> PlaceGraph::distances() const {
  std::vector<double> length(places_.size(), std::numeric_limits<double>::infinity());
  if (visits_.empty()) return length;
  std::vector<std::vector<std::pair<std::uint32_t, double>>> neighbours(places_.size());
  edges_.forEach([&](const Edge& e) {
    neighbours[e.a].emplace_back(e.b, e.length_m);
    neighbours[e.b].emplace_back(e.a, e.length_m);
  });
  using Open = std::pair<double, std::uint32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  length[visits_.back().place] = visits_.back().stub_m;
  open.emplace(visits_.back().stub_m, visits_.back().place);
  while (!open.empty()) {
    const auto [reached_m, place] = open.top();
    open.pop();
    if (reached_m > length[place]) continue;
    for (const auto& [next, edge] : neighbours[place])
      if (reached_m + edge < length[next]) {
        length[next] = reached_m + edge;
        open.emplace(length[next], next);
      }
  }
  return length;
}

std::size_t PlaceGraph::lastVisit(std::uint32_t place) const {
  for (std::size_t i = visits_.size(); i-- > 0;)
    if (visits_[i].place == place && visits_[i].inside) return i;
  return places_[place].step;
}

}  // namespace ariadne::loops
