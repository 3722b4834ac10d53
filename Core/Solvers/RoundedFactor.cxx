#include "RoundedFactor.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// sums += the columns times their factors, two columns at a time.
void addColumns(
  const float* column, int rows, int stride, int columns, const double* factors, double* sums)
{
  int j = 0;
  for (; j + 1 < columns; j += 2, column += 2 * static_cast<std::ptrdiff_t>(stride))
  {
    const float* next = column + stride;
    const double first = factors[j];
    const double second = factors[j + 1];
    for (int i = 0; i < rows; ++i)
    {
      sums[i] += first * static_cast<double>(column[i]) + second * static_cast<double>(next[i]);
    }
  }
  for (int i = 0; j < columns && i < rows; ++i)
  {
    sums[i] += factors[j] * static_cast<double>(column[i]);
  }
}

double product(const float* column, const double* vector, int rows)
{
  std::array<double, 4> sums{}; // in whose order compilers may not add
  int i = 0;
  for (; i + 3 < rows; i += 4)
  {
    for (int k = 0; k < 4; ++k)
    {
      sums[k] += static_cast<double>(column[i + k]) * vector[i + k];
    }
  }
  for (; i < rows; ++i)
  {
    sums[0] += static_cast<double>(column[i]) * vector[i];
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

RoundedFactor::RoundedFactor(std::vector<int> order, double scale, std::size_t entries)
  : order_(std::move(order))
  , scale_(scale)
{
  this->values_.reserve(entries);
}

void RoundedFactor::append(int columns, const std::vector<int>& rows, const double* values)
{
  const auto height = static_cast<int>(rows.size());
  this->blocks_.push_back(
    { rows.front(), columns, height - columns, this->rows_.size(), this->values_.size() });
  this->rows_.insert(this->rows_.end(), rows.begin() + columns, rows.end());
  std::transform(values, values + static_cast<std::ptrdiff_t>(height) * columns,
    std::back_inserter(this->values_),
    [this](double value) { return static_cast<float>(value / this->scale_); });
}

void RoundedFactor::forward(const Block& block, Values& vector, Values& work) const
{
  const int height = block.columns + block.below;
  const float* values = this->values_.data() + block.values;
  double* unknowns = vector.data() + block.first;
  for (int j = 0; j < block.columns; ++j)
  {
    const float* column = values + static_cast<std::ptrdiff_t>(j) * height;
    unknowns[j] /= static_cast<double>(column[j]);
    for (int i = j + 1; i < block.columns; ++i)
    {
      unknowns[i] -= unknowns[j] * static_cast<double>(column[i]);
    }
  }
  std::fill_n(work.data(), block.below, 0.0);
  addColumns(values + block.columns, block.below, height, block.columns, unknowns, work.data());
  const int* rows = this->rows_.data() + block.rows;
  for (int i = 0; i < block.below; ++i)
  {
    vector[rows[i]] -= work[i];
  }
}

void RoundedFactor::backward(const Block& block, Values& vector, Values& work) const
{
  const int height = block.columns + block.below;
  const float* values = this->values_.data() + block.values;
  double* unknowns = vector.data() + block.first;
  const int* rows = this->rows_.data() + block.rows;
  for (int i = 0; i < block.below; ++i)
  {
    work[i] = vector[rows[i]];
  }
  for (int j = block.columns - 1; j >= 0; --j)
  {
    const float* column = values + static_cast<std::ptrdiff_t>(j) * height;
    const double sum = product(column + j + 1, unknowns + j + 1, block.columns - j - 1) +
      product(column + block.columns, work.data(), block.below);
    unknowns[j] = (unknowns[j] - sum) / static_cast<double>(column[j]);
  }
}

Values RoundedFactor::solve(const ValuesRef& rightSide) const
{
  Values vector = rightSide(this->order_);
  Values work(vector.size());
  for (const Block& block : this->blocks_)
  {
    this->forward(block, vector, work);
  }
  std::for_each(this->blocks_.rbegin(), this->blocks_.rend(),
    [&](const Block& block) { this->backward(block, vector, work); });
  Values result(vector.size());
  result(this->order_) = vector / this->scale_ / this->scale_;
  return result;
}

} // namespace SurfaceScalars
