// What GLSL has built in and the shared text uses, for one scalar type Real. Included in the namespace of that type.
// Plain functions, not templates: a decimal literal then converts to Real, where GLM's templates would fail to deduce.
// GLM serves the rest (vec op vec, mat3 * vec3, dot, reflect, ...) through argument-dependent lookup.
inline Real abs(Real x) { return std::abs(x); }
inline Real min(Real a, Real b) { return b < a ? b : a; }
inline Real max(Real a, Real b) { return a < b ? b : a; }
inline Real clamp(Real x, Real low, Real high) { return min(max(x, low), high); }
inline Real mix(Real a, Real b, Real t) { return a * (Real(1) - t) + b * t; }
inline Real smoothstep(Real low, Real high, Real x) {
  const Real t = clamp((x - low) / (high - low), Real(0), Real(1));
  return t * t * (Real(3) - Real(2) * t);
}
inline Real sin(Real x) { return std::sin(x); }
inline Real cos(Real x) { return std::cos(x); }
inline Real exp2(Real x) { return std::exp2(x); }
inline Real exp(Real x) { return std::exp(x); }
inline Real log(Real x) { return std::log(x); }
inline Real log2(Real x) { return std::log2(x); }
inline Real pow(Real x, Real y) { return std::pow(x, y); }
inline Real sqrt(Real x) { return std::sqrt(x); }
inline Real inversesqrt(Real x) { return Real(1) / std::sqrt(x); }

inline vec3 min(const vec3& a, Real b) { return vec3(min(a.x, b), min(a.y, b), min(a.z, b)); }
inline vec3 max(const vec3& a, Real b) { return vec3(max(a.x, b), max(a.y, b), max(a.z, b)); }
inline vec3 clamp(const vec3& v, Real low, Real high) { return min(max(v, low), high); }
inline vec3 mix(const vec3& a, const vec3& b, Real t) { return a * (Real(1) - t) + b * t; }
inline vec3 exp(const vec3& v) { return vec3(std::exp(v.x), std::exp(v.y), std::exp(v.z)); }
inline vec3 log(const vec3& v) { return vec3(std::log(v.x), std::log(v.y), std::log(v.z)); }
inline vec3 log2(const vec3& v) { return vec3(std::log2(v.x), std::log2(v.y), std::log2(v.z)); }
inline vec3 pow(const vec3& v, const vec3& p) { return vec3(std::pow(v.x, p.x), std::pow(v.y, p.y), std::pow(v.z, p.z)); }

inline vec3 operator+(const vec3& v, Real s) { return vec3(v.x + s, v.y + s, v.z + s); }
inline vec3 operator-(const vec3& v, Real s) { return vec3(v.x - s, v.y - s, v.z - s); }
inline vec3 operator*(const vec3& v, Real s) { return vec3(v.x * s, v.y * s, v.z * s); }
inline vec3 operator/(const vec3& v, Real s) { return vec3(v.x / s, v.y / s, v.z / s); }
inline vec3 operator+(Real s, const vec3& v) { return vec3(s + v.x, s + v.y, s + v.z); }
inline vec3 operator-(Real s, const vec3& v) { return vec3(s - v.x, s - v.y, s - v.z); }
inline vec3 operator*(Real s, const vec3& v) { return vec3(s * v.x, s * v.y, s * v.z); }
inline vec3 operator/(Real s, const vec3& v) { return vec3(s / v.x, s / v.y, s / v.z); }
