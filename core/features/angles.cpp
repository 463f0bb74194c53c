// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/angles.h"

#include <algorithm>
#include <cmath>

#include "core/features/vector.h"

namespace confidel {

namespace {

/// An angle is accepted from doubles if its error bound is below this part of it.
constexpr double accepted_error = 2.5e-7;
/// Products of lengths below this may suffer from underflow.
constexpr double tiny_length = 1e-35;
/// Error of an angle from vectors whose components have relative errors of at most u. Cross product: each component at
/// most 3.01 u times |xy| + |x'y'|, together at most 4.3 u |a||b|; dot product at most 5 u |a||b|; the norm of the
/// cross product another 3 u of itself. The point (|cross|, dot) has modulus |a||b| and moves by at most 9 u of it;
/// atan2 adds less than 2 u pi.
constexpr double angle_error = 0x1p-48;

double from_products(const Vector& cross_product, double dot_product) {
  return std::atan2(std::sqrt(dot(cross_product, cross_product)), dot_product);
}

/// atan2(sqrt(sine), sign sqrt(cosine)) for exact squares, rounded down. Relative errors of the two arguments of at
/// most 2 u each, and one of 2 u for atan2 itself, move the angle by less than 8 u of it.
double angle_from_squares(const mpz_class& sine, const mpz_class& cosine, int sign) {
  long sine_power = 0;
  long cosine_power = 0;
  const auto root = [](const mpz_class& square, long& power) {
    double fraction = mpz_get_d_2exp(&power, square.get_mpz_t());
    if (power % 2 != 0) {
      fraction *= 2;
      --power;
    }
    power /= 2;
    return std::sqrt(fraction);
  };
  double y = root(sine, sine_power);
  double x = root(cosine, cosine_power);
  if (y == 0) return sign > 0 ? 0 : straight_angle;
  if (x != 0) y = std::ldexp(y, static_cast<int>(std::clamp(sine_power - cosine_power, -1060L, 1020L)));
  return std::min(std::atan2(y, sign < 0 ? -x : x) * (1 - 0x1p-49), straight_angle);
}

/// The vectors from v to the others: integers with a common factor, which angles do not feel.
IntegerVector integer_direction(const Corner& from, const Corner& to) {
  return difference(*to.point, *from.point).vector;
}

double exact_angle(const IntegerVector& a, const IntegerVector& b) {
  const IntegerVector normal = cross(a, b);
  const mpz_class product = dot(a, b);
  return angle_from_squares(dot(normal, normal), product * product, sgn(product));
}

double exact_sector_angle(const IntegerVector& direction, const IntegerVector& b, const IntegerVector& c) {
  const IntegerVector normal = cross(b, c);
  if (dot(cross(b, direction), normal) < 0 || dot(cross(direction, c), normal) < 0) {
    return std::min(exact_angle(direction, b), exact_angle(direction, c));
  }
  const mpz_class height = dot(direction, normal);
  const IntegerVector shadow = cross(direction, normal);
  return angle_from_squares(height * height, dot(shadow, shadow), 1);
}

bool decided(double angle, double error) { return error <= accepted_error * angle; }

}  // namespace

double angle_below(const Corner& v, const Corner& a, const Corner& b, double limit) {
  if (v.exact && a.exact && b.exact) {
    const Vector x = a.position - v.position;
    const Vector y = b.position - v.position;
    if (sum_of_magnitudes(x) > tiny_length && sum_of_magnitudes(y) > tiny_length) {
      const double angle = from_products(cross(x, y), dot(x, y));
      if (angle - angle_error >= limit || decided(angle, angle_error))
        return std::min(angle - angle_error, straight_angle);
    }
  }
  return exact_angle(integer_direction(v, a), integer_direction(v, b));
}

double sector_angle_below(const Corner& v, const Corner& a, const Corner& b, const Corner& c, double limit) {
  if (v.exact && a.exact && b.exact && c.exact) {
    const Vector direction = a.position - v.position;
    const Vector x = b.position - v.position;
    const Vector y = c.position - v.position;
    const double length_x = std::sqrt(dot(x, x));
    const double length_y = std::sqrt(dot(y, y));
    const double length = std::sqrt(dot(direction, direction));
    const Vector normal = cross(x, y);
    const double length_normal = std::sqrt(dot(normal, normal));
    if (std::min({length, length_x, length_y}) > tiny_length && length_normal > tiny_length * tiny_length) {
      const Vector from_x = cross(x, direction);
      const Vector to_y = cross(direction, y);
      // All three cross products have errors of at most 4.3 u times the two lengths, the products of two of them 13 u
      // times four.
      const double inside_x = dot(from_x, normal);
      const double inside_y = dot(to_y, normal);
      const double slack_x = 0x1p-48 * length_x * length_x * length_y * length;
      const double slack_y = 0x1p-48 * length_y * length_y * length_x * length;
      const bool outside = inside_x < -slack_x || inside_y < -slack_y;
      const bool inside = inside_x > slack_x && inside_y > slack_y;
      // The angle to the sector is between the one to its plane and the one to the nearer of its rays.
      double below = 0;
      double above = 0;
      double error = angle_error;
      if (!inside) {
        above = std::min(from_products(from_x, dot(x, direction)), from_products(to_y, dot(y, direction)));
        below = above;
      }
      if (!outside) {
        // The computed normal deviates by at most 4.5 u |x||y| / |normal| radian.
        below = std::atan2(std::abs(dot(direction, normal)), [&] {
          const Vector shadow = cross(direction, normal);
          return std::sqrt(dot(shadow, shadow));
        }());
        error += 0x1p-50 * length_x * length_y / length_normal;
        if (inside) above = below;
      }
      const double bound = below - error;
      if (bound >= limit || (decided(below, error) && above - below <= accepted_error * below)) {
        return std::min(bound, straight_angle);
      }
    }
  }
  return exact_sector_angle(integer_direction(v, a), integer_direction(v, b), integer_direction(v, c));
}

double dihedral_angle_below(const Corner& a, const Corner& b, const Corner& c, const Corner& d, double limit) {
  if (a.exact && b.exact && c.exact && d.exact) {
    const Vector along = b.position - a.position;
    const Vector x = c.position - a.position;
    const Vector y = d.position - a.position;
    const Vector normal_x = cross(along, x);
    const Vector normal_y = cross(along, y);
    const double length_x = std::sqrt(dot(normal_x, normal_x));
    const double length_y = std::sqrt(dot(normal_y, normal_y));
    if (std::min(length_x, length_y) > tiny_length) {
      const double length = std::sqrt(dot(along, along));
      // As above: each normal deviates by at most 4.5 u |along||x| / |normal|.
      const double error =
          angle_error + 0x1p-50 * length * (std::sqrt(dot(x, x)) / length_x + std::sqrt(dot(y, y)) / length_y);
      const double angle = from_products(cross(normal_x, normal_y), dot(normal_x, normal_y));
      if (angle - error >= limit || decided(angle, error)) return std::min(angle - error, straight_angle);
    }
  }
  const IntegerVector along = integer_direction(a, b);
  return exact_angle(cross(along, integer_direction(a, c)), cross(along, integer_direction(a, d)));
}

}  // namespace confidel
