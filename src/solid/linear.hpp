// Linear algebra of the solvers: the constant matrix that preconditions Eq. 6, ropes on top of it,
// and conjugate gradients on three coordinates at once.
#pragma once
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <functional>
#include <memory>
#include <optional>

#include "solid/body.hpp"

namespace bozzetto {

double dot(const PlaceList& a, const PlaceList& b);
/// y + s x
void addTimes(double s, const PlaceList& x, PlaceList& y);

/// Aᵀ(massScale·M + W)A, W the springs' graph Laplacian or nothing: scalar, for x, y, z alike.
enum class WithSprings : std::uint8_t { no, yes };
Eigen::SparseMatrix<double> controlMatrix(const Body& body, double massScale, WithSprings springs);

/// Solves with that matrix: factored when it is small, by its diagonal else.
class Preconditioner {
 public:
  enum class Kind : std::uint8_t { factored, diagonal };
  Preconditioner(const Eigen::SparseMatrix<double>& matrix, Kind kind);

  /// Ropes are added by Sherman, Morrison & Woodbury: each a row of A times its strength.
  void setRopes(const Body& body, std::span<const Rope> ropes);
  void solve(const PlaceList& b, PlaceList& x) const;
  /// aᵀ (matrix)⁻¹ a for the row of a mass point, ropes left out.
  double give(const Body& body, Id point) const;

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::VectorXd row(const Body& body, Id point) const;

  std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factor_;
  Eigen::VectorXd inverse_;
  Matrix arms_, reached_, small_;  // U, S⁻¹U, (C⁻¹ + UᵀS⁻¹U)⁻¹
};

struct CgResult {
  int iterations = 0;
  double residual = 0;
};

struct CgOptions {
  int most = 10;
  double tolerance = 1e-3;
  const Preconditioner* preconditioner = nullptr;  ///< plain when null
};

/// x towards operator⁻¹ b, from where x is.
CgResult conjugateGradients(const std::function<void(const PlaceList&, PlaceList&)>& apply,
                            const PlaceList& b, PlaceList& x, const CgOptions& options);

}  // namespace bozzetto
