#include "solid/linear.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace bozzetto {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Three = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

Sparse asEigen(const WeightRows& rows) {
  Triplets triplets;
  for (std::size_t row = 0; row < rows.rowCount(); ++row)
    for (Id n = rows.start[row]; n < rows.start[row + 1]; ++n)
      triplets.emplace_back(static_cast<int>(row), static_cast<int>(rows.columns[n]),
                            rows.weights[n]);
  Sparse matrix(static_cast<int>(rows.rowCount()), static_cast<int>(rows.columnCount));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

void addArm(Triplets& triplets, Id a, Id b, double weight) {
  const int i = static_cast<int>(a), j = static_cast<int>(b);
  triplets.emplace_back(i, i, weight);
  triplets.emplace_back(j, j, weight);
  triplets.emplace_back(i, j, -weight);
  triplets.emplace_back(j, i, -weight);
}

// k on edges, 2κ/L² on both arms of each angle (solid.md §2).
void addSprings(Triplets& triplets, const Springs& springs, const PlaceList& places) {
  for (const NormalSpring& spring : springs.normal())
    addArm(triplets, spring.a, spring.b, spring.stiffness);
  for (const QuadSprings& quad : springs.quads()) {
    for (std::size_t c = 0; c < 4; ++c) {
      for (const std::size_t other : {(c + 1) % 4, (c + 3) % 4}) {
        const glm::dvec3 arm = places[quad.points[other]] - places[quad.points[c]];
        const double squared = glm::dot(arm, arm);
        if (squared > 0)
          addArm(triplets, quad.points[c], quad.points[other], 2 * quad.stiffness[c] / squared);
      }
    }
  }
}

Eigen::Map<const Three> mapped(const PlaceList& list) {
  return {&list.data()->x, static_cast<Eigen::Index>(list.size()), 3};
}
Eigen::Map<Three> mapped(PlaceList& list) {
  return {&list.data()->x, static_cast<Eigen::Index>(list.size()), 3};
}

}  // namespace

double dot(const PlaceList& a, const PlaceList& b) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += glm::dot(a[n], b[n]);
  return sum;
}

void addTimes(double s, const PlaceList& x, PlaceList& y) {
  for (std::size_t n = 0; n < x.size(); ++n) y[n] += s * x[n];
}

Sparse controlMatrix(const Body& body, double massScale, WithSprings springs) {
  const auto count = static_cast<int>(body.mass.size());
  Triplets triplets;
  for (int n = 0; n < count; ++n)
    triplets.emplace_back(n, n, massScale * body.mass[static_cast<std::size_t>(n)]);
  if (springs == WithSprings::yes) addSprings(triplets, body.springs, body.refined.lattice.points);
  Sparse weights(count, count);
  weights.setFromTriplets(triplets.begin(), triplets.end());
  const Sparse a = asEigen(body.toMass);
  const Sparse right = weights * a;
  return Sparse(a.transpose()) * right;
}

Preconditioner::Preconditioner(const Sparse& matrix, Kind kind) {
  if (kind == Kind::factored) {
    factor_ = std::make_unique<Eigen::SimplicialLDLT<Sparse>>(matrix);
    if (factor_->info() == Eigen::Success) return;
    factor_.reset();
  }
  inverse_ = matrix.diagonal().cwiseMax(1e-12).cwiseInverse();
}

Eigen::VectorXd Preconditioner::row(const Body& body, Id point) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<int>(body.free.size()));
  const WeightRows& rows = body.toMass;
  for (Id n = rows.start[point]; n < rows.start[point + 1]; ++n)
    result[static_cast<int>(rows.columns[n])] = rows.weights[n];
  return result;
}

void Preconditioner::setRopes(const Body& body, std::span<const Rope> ropes) {
  const auto count = static_cast<int>(ropes.size());
  arms_.resize(static_cast<int>(body.free.size()), count);
  reached_.resize(arms_.rows(), count);
  if (count == 0) return;
  Matrix middle = Matrix::Zero(count, count);
  for (int n = 0; n < count; ++n) {
    const Rope& rope = ropes[static_cast<std::size_t>(n)];
    arms_.col(n) = row(body, rope.point);
    middle(n, n) = 1 / std::max(rope.strength, 1e-12);
  }
  reached_ = factor_ ? Matrix(factor_->solve(arms_)) : Matrix(inverse_.asDiagonal() * arms_);
  middle += arms_.transpose() * reached_;
  small_ = middle.inverse();
}

void Preconditioner::solve(const PlaceList& b, PlaceList& x) const {
  auto result = mapped(x);
  if (factor_) {
    result = factor_->solve(mapped(b));
  } else {
    result = inverse_.asDiagonal() * mapped(b);
  }
  if (arms_.cols() == 0) return;
  const Matrix pulled = small_ * (arms_.transpose() * result);
  result.noalias() -= reached_ * pulled;
}

double Preconditioner::give(const Body& body, Id point) const {
  const Eigen::VectorXd arm = row(body, point);
  if (!factor_) return arm.dot(inverse_.cwiseProduct(arm));
  const Eigen::VectorXd reached = factor_->solve(arm);
  return arm.dot(reached);
}

CgResult conjugateGradients(const std::function<void(const PlaceList&, PlaceList&)>& apply,
                            const PlaceList& b, PlaceList& x, const CgOptions& options) {
  const std::size_t count = b.size();
  PlaceList residual(count), direction(count), image(count), better(count);
  const auto improve = [&] {
    if (options.preconditioner != nullptr) {
      options.preconditioner->solve(residual, better);
    } else {
      better = residual;
    }
  };
  apply(x, image);
  for (std::size_t n = 0; n < count; ++n) residual[n] = b[n] - image[n];
  const double size = std::sqrt(dot(b, b));
  const double limit = options.tolerance * (size > 0 ? size : 1);

  CgResult result;
  double length = std::sqrt(dot(residual, residual));
  improve();
  direction = better;
  double slope = dot(residual, better);
  while (result.iterations < options.most && length > limit) {
    apply(direction, image);
    const double step = slope / dot(direction, image);
    if (!std::isfinite(step)) break;
    addTimes(step, direction, x);
    addTimes(-step, image, residual);
    length = std::sqrt(dot(residual, residual));
    ++result.iterations;
    if (length <= limit) break;
    improve();
    const double next = dot(residual, better);
    for (std::size_t n = 0; n < count; ++n)
      direction[n] = better[n] + (next / slope) * direction[n];
    slope = next;
  }
  result.residual = size > 0 ? length / size : 0;
  return result;
}

}  // namespace bozzetto
