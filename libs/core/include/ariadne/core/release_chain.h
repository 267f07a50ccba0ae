// Long lines of nodes that hold the one before them, freed without recursion: ten thousand would
// overflow the stack.
#pragma once
#include <memory>
#include <utility>

namespace ariadne::core {

/// To be called by a node's destructor: lets go the nodes that nobody else holds, one by one.
/// @param before gives the (mutable) pointer through which a node holds the one before it
template <class Node, class Before>
void releaseChain(std::shared_ptr<const Node> next, Before&& before) {
  while (next && next.use_count() == 1) {
    std::shared_ptr<const Node> above = std::move(before(*next));
    next = std::move(above);
  }
}

}  // namespace ariadne::core
