#include "RadialKernel.h"

#include "Error.h"

#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars
{

const char* nameOf(KernelType type)
{
  switch (type)
  {
    case KernelType::Gaussian:
      return "Gaussian";
    case KernelType::Exponential:
      return "Exponential";
    case KernelType::Linear:
      return "Linear";
    case KernelType::Cubic:
      return "Cubic";
    case KernelType::ThinPlate:
      return "ThinPlate";
    case KernelType::Multiquadric:
      return "Multiquadric";
    case KernelType::InverseMultiquadric:
      return "InverseMultiquadric";
    case KernelType::Wendland:
      return "Wendland";
    case KernelType::Wu:
      return "Wu";
    case KernelType::Harmonic:
      return "Harmonic";
  }
  return "unknown";
}

RadialKernel::RadialKernel(KernelType type, double width)
  : type_(type)
  , width_(width)
{
  if (!(width > 0.0) || !std::isfinite(width))
  {
    throw InvalidInput("a positive finite kernel width", std::to_string(width),
      "Use 0 for KernelWidth to have it chosen.");
  }
}

double RadialKernel::value(double radius) const
{
  const double t = radius / this->width_;
  switch (this->type_)
  {
    case KernelType::Gaussian:
      return std::exp(-t * t);
    case KernelType::Exponential:
      return std::exp(-t);
    case KernelType::Linear:
      return radius;
    case KernelType::Cubic:
      return t * t * t;
    case KernelType::ThinPlate:
      return t > 0.0 ? t * t * std::log(t) : 0.0;
    case KernelType::Multiquadric:
      return std::sqrt(1.0 + t * t);
    case KernelType::InverseMultiquadric:
      return 1.0 / std::sqrt(1.0 + t * t);
    case KernelType::Wendland:
    {
      const double s = t < 1.0 ? (1.0 - t) * (1.0 - t) : 0.0;
      return s * s * (4.0 * t + 1.0);
    }
    case KernelType::Wu:
    {
      const double s = t < 1.0 ? (1.0 - t) * (1.0 - t) : 0.0;
      return s * s * (4.0 + t * (16.0 + t * (12.0 + 3.0 * t)));
    }
    case KernelType::Harmonic:
      return 1.0 / radius;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void RadialKernel::apply(Eigen::Ref<Eigen::ArrayXd> squaredRadii) const
{
  auto& t = squaredRadii;
  const double inverse = 1.0 / this->width_;
  const double squaredInverse = inverse * inverse;
  switch (this->type_)
  {
    case KernelType::Gaussian:
      t = (-squaredInverse * t).exp();
      return;
    case KernelType::Exponential:
      t = (-inverse * t.sqrt()).exp();
      return;
    case KernelType::Linear:
      t = t.sqrt();
      return;
    case KernelType::Cubic:
      t *= (squaredInverse * inverse) * t.sqrt();
      return;
    case KernelType::ThinPlate:
      t *= squaredInverse;
      t = (t > 0.0).select(0.5 * t * t.log(), 0.0);
      return;
    case KernelType::Multiquadric:
      t = (1.0 + squaredInverse * t).sqrt();
      return;
    case KernelType::InverseMultiquadric:
      t = (1.0 + squaredInverse * t).sqrt().inverse();
      return;
    case KernelType::Wendland:
      t = inverse * t.sqrt();
      t = (1.0 - t).max(0.0).square().square() * (4.0 * t + 1.0);
      return;
    case KernelType::Wu:
      t = inverse * t.sqrt();
      t = (1.0 - t).max(0.0).square().square() * (4.0 + t * (16.0 + t * (12.0 + 3.0 * t)));
      return;
    case KernelType::Harmonic:
      t = t.sqrt().inverse();
      return;
  }
}

KernelJet RadialKernel::jet(double radius) const
{
  const double t = radius / this->width_;
  const double value = this->value(radius);
  const double inverse = 1.0 / (this->width_ * this->width_);
  const bool atCenter = !(radius > 0.0);
  switch (this->type_)
  {
    case KernelType::Gaussian:
      return { value, -2.0 * inverse * value, (4.0 * t * t - 2.0) * inverse * value };
    case KernelType::Exponential:
      return atCenter ? KernelJet{ value, 0.0, 0.0 }
                      : KernelJet{ value, -inverse * value / t, inverse * value };
    case KernelType::Linear:
      return { value, atCenter ? 0.0 : 1.0 / radius, 0.0 };
    case KernelType::Cubic:
      return { value, 3.0 * inverse * t, 6.0 * inverse * t };
    case KernelType::ThinPlate:
      return atCenter ? KernelJet{ 0.0, 0.0, 0.0 }
                      : KernelJet{ value, inverse * (2.0 * std::log(t) + 1.0),
                          inverse * (2.0 * std::log(t) + 3.0) };
    case KernelType::Multiquadric:
      return { value, inverse / value, inverse / (value * value * value) };
    case KernelType::InverseMultiquadric:
    {
      const double cube = value * value * value;
      return { value, -inverse * cube, inverse * (2.0 * t * t - 1.0) * cube * value * value };
    }
    case KernelType::Wendland:
    {
      const double s = t < 1.0 ? (1.0 - t) * (1.0 - t) : 0.0;
      return { value, -20.0 * inverse * s * (1.0 - t), 20.0 * inverse * s * (4.0 * t - 1.0) };
    }
    case KernelType::Wu:
    {
      const double s = t < 1.0 ? (1.0 - t) * (1.0 - t) : 0.0;
      return { value, inverse * s * (1.0 - t) * -(56.0 + t * (63.0 + 21.0 * t)),
        inverse * s * (-56.0 + t * (98.0 + t * (252.0 + t * 126.0))) };
    }
    case KernelType::Harmonic:
      return { value, -value * value * value, 2.0 * value * value * value };
  }
  return { value, value, value };
}

double RadialKernel::sign() const
{
  return this->type_ == KernelType::Linear || this->type_ == KernelType::Multiquadric ? -1.0 : 1.0;
}

int RadialKernel::order() const
{
  switch (this->type_)
  {
    case KernelType::Linear:
    case KernelType::Multiquadric:
      return 1;
    case KernelType::Cubic:
    case KernelType::ThinPlate:
      return 2;
    default:
      return 0;
  }
}

double RadialKernel::support() const
{
  return this->type_ == KernelType::Wendland || this->type_ == KernelType::Wu
    ? this->width_
    : std::numeric_limits<double>::infinity();
}

bool RadialKernel::dependsOnWidth() const
{
  return this->type_ != KernelType::Linear && this->type_ != KernelType::Cubic &&
    this->type_ != KernelType::ThinPlate && this->type_ != KernelType::Harmonic;
}

} // namespace SurfaceScalars
