#include "StarSigns.h"

#include <array>
#include <cstddef>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr double Impossible = -std::numeric_limits<double>::infinity();

/// Of the signs up to a vertex that end with one sign after some changes, the best.
struct Entry
{
  double agreement = Impossible;
  int previous = 0; ///< the sign before
};

int signOf(std::size_t side)
{
  return side == 0 ? -1 : 1;
}

class SignTable
{
public:
  SignTable(const std::vector<double>& wanted, const std::vector<int>& forced, int changes)
    : wanted_(wanted)
    , forced_(forced)
    , changes_(static_cast<std::size_t>(changes))
    , entries_(wanted.size() * (this->changes_ + 1))
  {
  }

  void fill(std::size_t firstSide);
  const Entry& last(std::size_t side, std::size_t changes) const
  {
    return this->at(this->wanted_.size() - 1, changes)[side];
  }
  std::vector<int> trace(std::size_t side, std::size_t changes) const;

private:
  using Sides = std::array<Entry, 2>; ///< of sign -1 and 1

  Sides& at(std::size_t vertex, std::size_t changes)
  {
    return this->entries_[vertex * (this->changes_ + 1) + changes];
  }
  const Sides& at(std::size_t vertex, std::size_t changes) const
  {
    return this->entries_[vertex * (this->changes_ + 1) + changes];
  }
  bool isAllowed(std::size_t vertex, std::size_t side) const
  {
    return this->forced_[vertex] != -signOf(side);
  }

  const std::vector<double>& wanted_;
  const std::vector<int>& forced_;
  std::size_t changes_;
  std::vector<Sides> entries_;
};

void SignTable::fill(std::size_t firstSide)
{
  this->entries_.assign(this->entries_.size(), {});
  if (this->isAllowed(0, firstSide))
  {
    this->at(0, 0)[firstSide] = { signOf(firstSide) * this->wanted_[0], 0 };
  }
  for (std::size_t vertex = 1; vertex < this->wanted_.size(); ++vertex)
  {
    for (std::size_t changes = 0; changes <= this->changes_; ++changes)
    {
      for (std::size_t side = 0; side < 2; ++side)
      {
        const Entry& same = this->at(vertex - 1, changes)[side];
        const Entry other = changes > 0 ? this->at(vertex - 1, changes - 1)[1 - side] : Entry();
        const bool isSame = same.agreement >= other.agreement;
        const double before = isSame ? same.agreement : other.agreement;
        if (before != Impossible && this->isAllowed(vertex, side))
        {
          this->at(vertex, changes)[side] = { before + signOf(side) * this->wanted_[vertex],
            isSame ? signOf(side) : -signOf(side) };
        }
      }
    }
  }
}

std::vector<int> SignTable::trace(std::size_t side, std::size_t changes) const
{
  std::vector<int> signs(this->wanted_.size());
  for (std::size_t vertex = signs.size(); vertex-- > 0;)
  {
    signs[vertex] = signOf(side);
    const int previous = this->at(vertex, changes)[side].previous;
    if (vertex > 0 && previous != signs[vertex])
    {
      side = 1 - side;
      --changes;
    }
  }
  return signs;
}

} // namespace

std::vector<int> closestSigns(
  const std::vector<double>& wanted, const std::vector<int>& forced, bool isClosed, int changes)
{
  std::vector<int> best;
  double bestAgreement = Impossible;
  if (wanted.empty() || changes < 0)
  {
    return best;
  }
  SignTable table(wanted, forced, changes);
  for (std::size_t first = 0; first < 2; ++first)
  {
    table.fill(first);
    for (std::size_t last = 0; last < 2; ++last)
    {
      const bool closes = isClosed && first != last; // a change from the last to the first
      const int along = changes - (closes ? 1 : 0);
      if (along >= 0 && table.last(last, static_cast<std::size_t>(along)).agreement > bestAgreement)
      {
        bestAgreement = table.last(last, static_cast<std::size_t>(along)).agreement;
        best = table.trace(last, static_cast<std::size_t>(along));
      }
    }
  }
  return best;
}

} // namespace SurfaceScalars
