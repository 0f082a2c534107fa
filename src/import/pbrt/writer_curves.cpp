#include "import/pbrt/writer_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ajar::pbrt {
namespace {

struct Piece {
  std::array<Vec3, 4> points, normals;
  std::array<float, 4> widths;
};

constexpr int kMostHalvings = 6;

float tolerance(const Piece& piece) {
  return 1e-3F * *std::max_element(piece.widths.begin(), piece.widths.end());
}

bool is_even(const Piece& piece) {
  const auto& w = piece.widths;
  for (std::size_t i = 1; i < 3; ++i) {
    const float even = lerp(static_cast<float>(i) / 3.F, w[0], w[3]);
    if (std::abs(w[i] - even) > tolerance(piece)) return false;
  }
  return true;
}

/// De Casteljau's algorithm at the middle.
template <typename Value>
void halve(const std::array<Value, 4>& c, std::array<Value, 4>& first,
           std::array<Value, 4>& second) {
  const Value ab = (c[0] + c[1]) * 0.5F;
  const Value bc = (c[1] + c[2]) * 0.5F;
  const Value cd = (c[2] + c[3]) * 0.5F;
  const Value abc = (ab + bc) * 0.5F;
  const Value bcd = (bc + cd) * 0.5F;
  const Value middle = (abc + bcd) * 0.5F;
  first = {c[0], ab, abc, middle};
  second = {middle, bcd, cd, c[3]};
}

void add_even_pieces(const Piece& piece, int halvings, std::vector<Piece>& pieces) {
  if (halvings == 0 || is_even(piece)) {
    pieces.push_back(piece);
    return;
  }
  Piece first, second;
  halve(piece.points, first.points, second.points);
  halve(piece.normals, first.normals, second.normals);
  halve(piece.widths, first.widths, second.widths);
  add_even_pieces(first, halvings - 1, pieces);
  add_even_pieces(second, halvings - 1, pieces);
}

std::vector<Piece> even_pieces(const desc::Curves& curves) {
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < curves.control_points.size(); s += 4) {
    Piece piece;
    for (std::size_t i = 0; i < 4; ++i) {
      piece.points[i] = curves.control_points[s + i];
      piece.widths[i] = curves.widths[s + i];
      piece.normals[i] = curves.normals.empty() ? Vec3(0.F) : curves.normals[s + i];
    }
    add_even_pieces(piece, kMostHalvings, pieces);
  }
  return pieces;
}

/// `next` begins where `last` ends, and its width changes as much as that of `first`.
bool goes_on(const Piece& first, const Piece& last, const Piece& next) {
  const float most = std::max(tolerance(first), tolerance(next));
  return last.points[3] == next.points[0] && last.normals[3] == next.normals[0] &&
         std::abs(last.widths[3] - next.widths[0]) <= most &&
         std::abs((next.widths[3] - next.widths[0]) - (first.widths[3] - first.widths[0])) <= most;
}

}  // namespace

std::vector<CurveChain> curve_chains(const desc::Curves& curves) {
  const std::vector<Piece> pieces = even_pieces(curves);
  std::vector<CurveChain> chains;
  std::size_t first = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (i == 0 || !goes_on(pieces[first], pieces[i - 1], piece)) {
      first = i;
      CurveChain& chain = chains.emplace_back();
      chain.points.push_back(piece.points[0]);
      chain.width0 = piece.widths[0];
      if (!curves.normals.empty()) chain.normals.push_back(piece.normals[0]);
    }
    CurveChain& chain = chains.back();
    chain.points.insert(chain.points.end(), piece.points.begin() + 1, piece.points.end());
    chain.width1 = piece.widths[3];
    if (!curves.normals.empty()) chain.normals.push_back(piece.normals[3]);
  }
  return chains;
}

}  // namespace ajar::pbrt
