// The ground: a level rectangle that shows nothing but shadows.
#define VARYING out
layout(location = 0) in vec3 position;  // about its centre, metres

uniform mat4 modelMatrix;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;

#include "shadow/coords.glsl"

void main() {
  gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
  setShadowCoords(position, normalMatrix * vec3(0.0, 1.0, 0.0));
}
