// One face of a cube map: a triangle over the viewport, with the direction of each point of the face.
uniform vec3 faceRight;   // how the direction changes along +s
uniform vec3 faceUp;      // and along +t
uniform vec3 faceCentre;

out vec3 vDirection;  // not unit; linear over the face

void main() {
  vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2)) * 2.0 - 1.0;
  vDirection = faceCentre + corner.x * faceRight + corner.y * faceUp;
  gl_Position = vec4(corner, 0.0, 1.0);
}
