// The environment behind everything: a unit cube around the eye, at the far plane.
layout(location = 0) in vec3 position;  // corners of a cube of edge 1

uniform mat4 modelViewMatrix;  // view rotation: the cube moves with the eye
uniform mat4 projectionMatrix;

out vec3 vDirection;  // world space

void main() {
  vDirection = normalize(position);
  gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
  gl_Position.z = gl_Position.w;
}
