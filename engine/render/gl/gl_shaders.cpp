#include "render/gl/gl_shaders.hpp"

#include "core/text.hpp"
#include "platform/gl_profile.hpp"

namespace plumb {
namespace {

std::string firstLines() {
    return std::string{shaderVersion()} + "precision highp float;\nprecision highp int;\n";
}

// The corner is computed from gl_VertexID: 0 1 / 2 3, a strip of two triangles.
constexpr const char* kSpriteVertex = R"(
layout(location = 0) in vec2 center;
layout(location = 1) in vec2 extent;
layout(location = 2) in float rotation;
layout(location = 3) in vec4 source;
layout(location = 4) in vec4 tint;
layout(location = 5) in uint slot;
uniform vec2 viewX;
uniform vec2 viewY;
uniform vec2 viewOffset;
uniform vec4 batchTint;
uniform vec2 texelScale[SLOTS];
out vec2 uv;
out vec4 color;
flat out vec4 bounds;
flat out uint textureSlot;
flat out float cover;
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    vec2 local = (corner * 2.0 - 1.0) * extent;
    float s = sin(rotation);
    float c = cos(rotation);
    vec2 world = center + vec2(c * local.x - s * local.y, s * local.x + c * local.y);
    gl_Position = vec4(dot(viewX, world) + viewOffset.x, dot(viewY, world) + viewOffset.y, 0.0, 1.0);

    textureSlot = slot & 0xffu;
    vec2 scale = texelScale[textureSlot];
    vec2 at = (slot & 0x100u) != 0u ? corner.yx : corner;
    uv = mix(source.xy, source.zw, at) * scale;
    // Sampling stays half a texel (2 quarters) inside the source, so that neighbors never bleed in.
    vec2 low = min(source.xy, source.zw);
    vec2 high = max(source.xy, source.zw);
    vec2 middle = (low + high) * 0.5;
    bounds = vec4(min(low + 2.0, middle) * scale, max(high - 2.0, middle) * scale);
    color = tint * batchTint;
    cover = (slot & 0x200u) != 0u ? 0.0 : 1.0;
}
)";

// Uses a switch, because before OpenGL 4 arrays of samplers can be indexed only by constants.
constexpr const char* kSpriteFragment = R"(
uniform sampler2D slots[SLOTS];
in vec2 uv;
in vec4 color;
flat in vec4 bounds;
flat in uint textureSlot;
flat in float cover;
out vec4 pixel;
vec4 sampleSlot(vec2 at) {
SAMPLES
}
void main() {
    vec4 shown = sampleSlot(clamp(uv, bounds.xy, bounds.zw)) * color;
    pixel = vec4(shown.rgb * shown.a, shown.a * cover);
}
)";

constexpr const char* kGeometryVertex = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 tint;
uniform vec2 viewX;
uniform vec2 viewY;
uniform vec2 viewOffset;
out vec4 color;
void main() {
    gl_Position = vec4(dot(viewX, position) + viewOffset.x, dot(viewY, position) + viewOffset.y, 0.0, 1.0);
    color = vec4(tint.rgb * tint.a, tint.a);
}
)";

// The vertex shader premultiplies the color: if the fragment shader does it, Mesa's
// software renderer (22.3) draws wrong colors in fully covered squares of 64 px.
constexpr const char* kGeometryFragment = R"(
in vec4 color;
out vec4 pixel;
void main() { pixel = color; }
)";

// The texture's first row is the top one. `up` is 1 if clip space y points up in the target, else -1.
constexpr const char* kPictureVertex = R"(
uniform float up;
out vec2 uv;
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    uv = vec2(corner.x, 1.0 - corner.y);
    gl_Position = vec4((corner * 2.0 - 1.0) * vec2(1.0, up), 0.0, 1.0);
}
)";

constexpr const char* kPictureFragment = R"(
uniform sampler2D picture;
in vec2 uv;
out vec4 pixel;
void main() { pixel = texture(picture, uv); }
)";

std::string withSlots(std::string source, std::size_t slots) {
    const std::string name = "SLOTS";
    const std::string number = std::to_string(slots);
    for (std::size_t at = source.find(name); at != std::string::npos; at = source.find(name)) {
        source.replace(at, name.size(), number);
    }
    return source;
}

/// Returns the code that samples the texture of a slot. textureLod needs no derivatives, which would be
/// undefined inside a switch.
std::string samples(std::size_t slots) {
    if (slots == 1) return "    return textureLod(slots[0], at, 0.0);";
    std::string lines = "    switch (textureSlot) {\n";
    for (std::size_t i = 1; i < slots; ++i) {
        lines += format("        case {}u: return textureLod(slots[{}], at, 0.0);\n", i, i);
    }
    return lines + "        default: return textureLod(slots[0], at, 0.0);\n    }";
}

}  // namespace

ShaderSources spriteShaders(std::size_t slots) {
    std::string fragment = withSlots(kSpriteFragment, slots);
    const std::string mark = "SAMPLES";
    fragment.replace(fragment.find(mark), mark.size(), samples(slots));
    return {firstLines() + withSlots(kSpriteVertex, slots), firstLines() + fragment};
}

ShaderSources geometryShaders() { return {firstLines() + kGeometryVertex, firstLines() + kGeometryFragment}; }

ShaderSources textureShaders() { return {firstLines() + kPictureVertex, firstLines() + kPictureFragment}; }

}  // namespace plumb
