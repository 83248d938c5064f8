#pragma once

#include <thelma/mesh/mesh.h>

#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// Which bodies of a mesh, parts that share no vertex, could move or turn without strain.
template <int dim>
class RigidMotions
{
public:
  explicit RigidMotions(const Mesh<dim>& mesh);

  /// The displacement @p component of a named surface, line or point is given.
  void hold(const std::string& surface, unsigned int component);

  /// A sentence, without place, for every body that is not held.
  std::vector<std::string> remaining() const;

private:
  using Held = std::pair<dealii::Point<dim>, unsigned int>;

  /// Connected vertices that hold nothing or something, and their region.
  struct Body {
    std::string region;
    dealii::Point<dim> centre;
    std::vector<Held> held;
  };

  static std::vector<std::string> free_motions(const Body& body);

  const Mesh<dim>& mesh;
  std::vector<unsigned int> body_of_vertex;
  std::vector<Body> bodies;
};

} // namespace thelma
