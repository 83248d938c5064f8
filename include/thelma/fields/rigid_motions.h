#pragma once

#include <thelma/mesh/mesh.h>

#include <string>
#include <vector>

namespace thelma
{

/// Which bodies of a mesh could move or turn without strain.
template <int dim>
class RigidMotions
{
public:
  explicit RigidMotions(const Mesh<dim>& mesh) : mesh(mesh) {}

  /// The displacement @p component of a named surface, line or point is given.
  void hold(const std::string& surface, unsigned int component);

  /// A sentence, without place, for every body that is not held; the same on all ranks, which must
  /// all ask.
  std::vector<std::string> remaining() const;

private:
  /// A component of the displacement that is given at a vertex.
  struct Held {
    unsigned int body, component;
    dealii::Point<dim> X;

    template <class Archive>
    void serialize(Archive& archive, unsigned int)
    {
      archive& body& component& X;
    }
  };

  std::vector<std::string> free_motions(const std::vector<Held>& body) const;

  const Mesh<dim>& mesh;
  std::vector<Held> own; ///< by this rank's cells
};

} // namespace thelma
