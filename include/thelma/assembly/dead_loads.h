#pragma once

#include <thelma/fields/layout.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace thelma
{

/// Forces on surfaces that keep size and direction while the body deforms, spread evenly over the
/// undeformed surface.
template <int dim>
class DeadLoads
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Throws InputError for unknown surfaces and for texts that are no forces.
  void setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout);

  bool exist() const { return !texts.empty(); }

  /// The nodal forces in N (in plane strain N per mm of depth).
  const BlockVector& nodal() const { return forces; }

private:
  void add(const Mesh<dim>& mesh, const FieldLayout<dim>& layout, const std::string& surface,
           const dealii::Tensor<1, dim>& force);

  std::map<std::string, std::string> texts;
  BlockVector forces;
};

} // namespace thelma
