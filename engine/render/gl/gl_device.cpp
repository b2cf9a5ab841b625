#include "render/gl/gl_device.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <epoxy/gl.h>
#include <utility>

#include "core/log.hpp"
#include "render/gl/buffer_mapping.hpp"
#include "render/gl/gl_shaders.hpp"

namespace plumb {
namespace {

// Maximum number of textures per batch in software renderers, which sample every slot of the switch for
// every pixel: 1000 sprites on three backdrops take 7 ms with 1 slot, 10 ms with 4, 36 ms with 16.
constexpr std::size_t kSoftwareSlots = 4;
constexpr std::array<std::size_t, 8> kProgramSlots{1, 2, 3, 4, 6, 8, 12, kTextureSlots};
constexpr int kOldestVersion = 33;

const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}  // OpenGL passes offsets as pointers

/// Lets the instance attributes of the bound vertex array begin at instance `first` of the bound buffer.
void pointAtInstances(std::size_t first) {
    constexpr GLsizei kStride = sizeof(SpriteInstance);
    const std::size_t start = first * sizeof(SpriteInstance);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(start + offsetof(SpriteInstance, center)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(start + offsetof(SpriteInstance, half)));
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(start + offsetof(SpriteInstance, rotation)));
    glVertexAttribPointer(3, 4, GL_UNSIGNED_SHORT, GL_FALSE, kStride,
                          bufferOffset(start + offsetof(SpriteInstance, uv)));
    glVertexAttribPointer(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          bufferOffset(start + offsetof(SpriteInstance, tint)));
    glVertexAttribIPointer(5, 1, GL_UNSIGNED_INT, kStride,
                           bufferOffset(start + offsetof(SpriteInstance, slot)));
}

GlName makeTexture(PixelSize size, TextureFilter filter, const std::uint8_t* rgba) {
    GlName name = 0;
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, name);
    const GLint mode = filter == TextureFilter::Nearest ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mode);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mode);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    return name;
}

Result<GlProgram> buildSpriteProgram(std::size_t slots) {
    const ShaderSources sources = spriteShaders(slots);
    Result<GlProgram> program = buildProgram(sources.vertex, sources.fragment);
    if (!program) return program;
    program->slots = slots;
    glUseProgram(program->name);
    std::array<GLint, kTextureSlots> units{};
    for (std::size_t i = 0; i < slots; ++i) units[i] = static_cast<GLint>(i);
    glUniform1iv(glGetUniformLocation(program->name, "slots"), static_cast<GLsizei>(slots), units.data());
    return program;
}

bool isSoftware(const std::string& renderer) {
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "Software"}) {
        if (renderer.find(name) != std::string::npos) return true;
    }
    return false;
}

/// Reverses the order of rows: OpenGL stores the lowest row first, Image the highest.
void flipRows(Image& image) {
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(image.width) * 4;
    for (int y = 0; y < image.height / 2; ++y) {
        const auto top = image.rgba.begin() + row * y;
        std::swap_ranges(top, top + row, image.rgba.begin() + row * (image.height - 1 - y));
    }
}

}  // namespace

Result<std::unique_ptr<GlDevice>> GlDevice::create() {
    if (epoxy_gl_version() < kOldestVersion) {
        return Error{"OpenGL", format("version {} is too old, expected at least 33", epoxy_gl_version()),
                     "update the graphics driver; Plumb needs OpenGL 3.3"};
    }
    std::unique_ptr<GlDevice> device{new GlDevice};
    device->createState();
    if (const Result<Done> built = device->buildPrograms(); !built) return built.error();
    return device;
}

void GlDevice::createState() {
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maxTextureSide_);
    software_ = isSoftware(description());
    if (software_) batchTextures_ = kSoftwareSlots;
    buffers_.resize(1);
    for (FrameBuffer& frame : frames_) glGenBuffers(1, &frame.name);
    glGenVertexArrays(1, &spriteArray_);
    glBindVertexArray(spriteArray_);
    for (GLuint i = 0; i < 6; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    glGenVertexArrays(1, &emptyArray_);
    glGenBuffers(1, &geometryBuffer_);
    glGenVertexArrays(1, &geometryArray_);
    glBindVertexArray(geometryArray_);
    glBindBuffer(GL_ARRAY_BUFFER, geometryBuffer_);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    constexpr GLsizei kStride = sizeof(GeometryVertex);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(offsetof(GeometryVertex, position)));
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          bufferOffset(offsetof(GeometryVertex, color)));

    targets_.resize(1);
    createTexture(Image{1, 1, {255, 255, 255, 255}}, TextureFilter::Nearest);  // texture 0
}

Result<Done> GlDevice::buildPrograms() {
    if (const Result<GlProgram> one = buildSpriteProgram(1); one) {
        spritePrograms_[1] = *one;
    } else {
        return one.error();
    }
    const ShaderSources sources = geometryShaders();
    Result<GlProgram> program = buildProgram(sources.vertex, sources.fragment);
    if (!program) return program.error();
    geometryProgram_ = *program;
    const ShaderSources picture = textureShaders();
    program = buildProgram(picture.vertex, picture.fragment);
    if (!program) return program.error();
    textureProgram_ = *program;
    return Done{};
}

GlDevice::~GlDevice() {
    for (const Texture& texture : textures_) glDeleteTextures(1, &texture.name);
    for (const Target& target : targets_) {
        if (target.name != 0) glDeleteFramebuffers(1, &target.name);
    }
    glDeleteRenderbuffers(1, &windowSamplesBuffer_);
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    for (const FrameBuffer& frame : frames_) {
        glDeleteBuffers(1, &frame.name);
        if (frame.fence != nullptr) glDeleteSync(static_cast<GLsync>(frame.fence));
    }
    glDeleteBuffers(1, &geometryBuffer_);
    glDeleteVertexArrays(1, &spriteArray_);
    glDeleteVertexArrays(1, &geometryArray_);
    glDeleteVertexArrays(1, &emptyArray_);
    for (const GlProgram& program : spritePrograms_) glDeleteProgram(program.name);  // 0 is ignored
    glDeleteProgram(geometryProgram_.name);
    glDeleteProgram(textureProgram_.name);
}

TextureHandle GlDevice::storeTexture(Texture texture) {
    if (freeTextures_.empty()) {
        textures_.push_back(texture);
        return {static_cast<std::uint32_t>(textures_.size() - 1)};
    }
    const TextureHandle handle{freeTextures_.back()};
    freeTextures_.pop_back();
    textures_[handle.index] = texture;
    return handle;
}

TextureHandle GlDevice::createTexture(const Image& image, TextureFilter filter) {
    const PixelSize size{image.width, image.height};
    if (image.empty() || size.width > maxTextureSide_ || size.height > maxTextureSide_) {
        logWarning("Render", Error{"texture", format("{}x{} px is not supported", size.width, size.height),
                                   format("each side of an image must be 1 to {} px", maxTextureSide_)});
        return {};
    }
    return storeTexture({makeTexture(size, filter, image.rgba.data()), size});
}

void GlDevice::updateTexture(TextureHandle texture, int x, int y, const Image& image) {
    const Texture& known = textures_[texture.index];
    PLUMB_ASSERT(
        x >= 0 && y >= 0 && x + image.width <= known.size.width && y + image.height <= known.size.height,
        "an update must lie inside its texture");
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, known.name);
    glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.rgba.data());
}

void GlDevice::destroyTexture(TextureHandle texture) {
    if (texture.index == 0) return;
    glDeleteTextures(1, &textures_[texture.index].name);
    textures_[texture.index] = {};
    freeTextures_.push_back(texture.index);
}

PixelSize GlDevice::textureSize(TextureHandle texture) const { return textures_[texture.index].size; }
std::uintptr_t GlDevice::nativeTexture(TextureHandle texture) const { return textures_[texture.index].name; }

TargetHandle GlDevice::createTarget(int width, int height) {
    Target target;
    const PixelSize size{std::clamp(width, 1, maxTextureSide_), std::clamp(height, 1, maxTextureSide_)};
    target.texture = storeTexture({makeTexture(size, TextureFilter::Nearest, nullptr), size});
    glGenFramebuffers(1, &target.name);
    glBindFramebuffer(GL_FRAMEBUFFER, target.name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           textures_[target.texture.index].name, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    targets_.push_back(target);
    return {static_cast<std::uint32_t>(targets_.size() - 1)};
}

void GlDevice::destroyTarget(TargetHandle target) {
    if (target.index == 0) return;
    Target& removed = targets_[target.index];
    glDeleteFramebuffers(1, &removed.name);
    destroyTexture(removed.texture);
    removed = {};
}

TextureHandle GlDevice::targetTexture(TargetHandle target) const { return targets_[target.index].texture; }

InstanceBufferHandle GlDevice::createInstances(std::span<const SpriteInstance> instances) {
    GlName name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                 GL_STATIC_DRAW);
    if (freeBuffers_.empty()) {
        buffers_.push_back(name);
        return {static_cast<std::uint32_t>(buffers_.size() - 1)};
    }
    const InstanceBufferHandle handle{freeBuffers_.back()};
    freeBuffers_.pop_back();
    buffers_[handle.index] = name;
    return handle;
}

void GlDevice::destroyInstances(InstanceBufferHandle buffer) {
    if (buffer.index == 0) return;
    glDeleteBuffers(1, &buffers_[buffer.index]);
    buffers_[buffer.index] = 0;
    freeBuffers_.push_back(buffer.index);
}

void GlDevice::enableMultisampling(int samples) {
    GLint maximum = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &maximum);
    windowSamples_ = std::clamp(samples, 1, static_cast<int>(maximum));
    if (windowSamples_ == 1 || targets_[0].name != 0) return;
    glGenFramebuffers(1, &targets_[0].name);
    glGenRenderbuffers(1, &windowSamplesBuffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, windowSamplesBuffer_);  // binding creates the object
    glBindFramebuffer(GL_FRAMEBUFFER, targets_[0].name);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, windowSamplesBuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    setWindowSize(std::exchange(windowSize_, PixelSize{}));
}

void GlDevice::setWindowSize(PixelSize size) {
    if (windowSamplesBuffer_ != 0 && size != windowSize_) {
        glBindRenderbuffer(GL_RENDERBUFFER, windowSamplesBuffer_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, windowSamples_, GL_RGBA8, size.width, size.height);
    }
    windowSize_ = size;
}

void GlDevice::resolveWindow() {
    if (windowSamplesBuffer_ == 0) return;
    const int width = windowSize_.width, height = windowSize_.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, targets_[0].name);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void GlDevice::setViewport(const Viewport& viewport) {
    // Other code, such as the editor's ImGui, draws in the same context: set all relevant state again.
    glBindFramebuffer(GL_FRAMEBUFFER, targets_[viewport.target.index].name);
    flipped_ = viewport.target.index != 0;
    const int y = flipped_ ? viewport.y : windowSize_.height - viewport.y - viewport.height;
    glViewport(viewport.x, y, viewport.width, viewport.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // the shaders premultiply by the opacity
}

void GlDevice::clear(Color color) {
    constexpr float kScale = 1.0f / 255.0f;
    glClearColor(static_cast<float>(color.r) * kScale, static_cast<float>(color.g) * kScale,
                 static_cast<float>(color.b) * kScale, static_cast<float>(color.a) * kScale);
    glClear(GL_COLOR_BUFFER_BIT);
}

/// Switches to the least recently written buffer, with new memory if the card still reads it.
/// Orphaning the buffer every time would be slower, because the driver would clear the new memory's pages.
GlDevice::FrameBuffer& GlDevice::nextFrameBuffer(std::size_t count) {
    frames_[frame_].fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    frame_ = (frame_ + 1) % frames_.size();
    FrameBuffer& frame = frames_[frame_];
    bool inUse = false;
    if (frame.fence != nullptr) {
        const auto fence = static_cast<GLsync>(std::exchange(frame.fence, nullptr));
        inUse = glClientWaitSync(fence, 0, 0) == GL_TIMEOUT_EXPIRED;
        glDeleteSync(fence);
    }
    glBindBuffer(GL_ARRAY_BUFFER, frame.name);
    if (inUse || frame.capacity < count) {
        frame.capacity = std::max(frame.capacity, count + count / 4);
        const auto bytes = static_cast<GLsizeiptr>(frame.capacity * sizeof(SpriteInstance));
        glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
    }
    return frame;
}

std::span<SpriteInstance> GlDevice::mapInstances(std::size_t count) {
    if (count == 0) return {};
    nextFrameBuffer(count);
    // Unsynchronized: nextFrameBuffer() made sure that the GPU does not read this memory.
    void* memory = mapArrayBuffer(count * sizeof(SpriteInstance));
    ownCount_ = memory == nullptr ? count : 0;
    if (memory != nullptr) return {static_cast<SpriteInstance*>(memory), count};
    ownMemory_.resize(std::max(ownMemory_.size(), count));
    return {ownMemory_.data(), count};
}

void GlDevice::unmapInstances() {
    glBindBuffer(GL_ARRAY_BUFFER, frames_[frame_].name);
    if (ownCount_ > 0) {
        glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(ownCount_ * sizeof(SpriteInstance)),
                        ownMemory_.data());
        ownCount_ = 0;
    } else {
        unmapArrayBuffer();
    }
}

const GlProgram& GlDevice::spriteProgramFor(std::size_t textureCount) {
    const std::size_t slots = *std::lower_bound(kProgramSlots.begin(), kProgramSlots.end(), textureCount);
    GlProgram& program = spritePrograms_[slots];
    if (program.name == 0) {
        const Result<GlProgram> built = buildSpriteProgram(slots);
        if (!built) logError("Render", built.error());
        program = built ? *built : spritePrograms_[1];
    }
    return program;
}

void GlDevice::setTransform(const GlProgram& program, const ViewTransform& transform) const {
    const float up = flipped_ ? -1.0f : 1.0f;
    glUniform2f(program.viewX, transform.x.x, transform.x.y);
    glUniform2f(program.viewY, transform.y.x * up, transform.y.y * up);
    glUniform2f(program.viewOffset, transform.offset.x, transform.offset.y * up);
}

void GlDevice::bindTextures(const SpriteBatch& batch, const GlProgram& program) {
    std::array<Vec2, kTextureSlots> scales{};
    for (std::size_t i = 0; i < batch.textureCount; ++i) {
        const Texture& texture = textures_[batch.textures[i].index];
        scales[i] = {1.0f / (kUvPerTexel * static_cast<float>(texture.size.width)),
                     1.0f / (kUvPerTexel * static_cast<float>(texture.size.height))};
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, texture.name);
    }
    glUniform2fv(program.texelScale, static_cast<GLsizei>(program.slots), &scales[0].x);
}

void GlDevice::drawSprites(const SpriteBatch& batch) {
    if (batch.count == 0) return;
    const GlProgram& program = spriteProgramFor(batch.textureCount);
    glUseProgram(program.name);
    setTransform(program, batch.transform);
    constexpr float kScale = 1.0f / 255.0f;
    glUniform4f(program.tint, static_cast<float>(batch.tint.r) * kScale,
                static_cast<float>(batch.tint.g) * kScale, static_cast<float>(batch.tint.b) * kScale,
                static_cast<float>(batch.tint.a) * kScale);
    bindTextures(batch, program);
    glBindVertexArray(spriteArray_);
    const bool retained = batch.buffer.index != 0;
    glBindBuffer(GL_ARRAY_BUFFER, retained ? buffers_[batch.buffer.index] : frames_[frame_].name);
    pointAtInstances(batch.first);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.count));
}

void GlDevice::drawGeometry(const GeometryBatch& batch) {
    if (batch.vertices.empty()) return;
    glUseProgram(geometryProgram_.name);
    setTransform(geometryProgram_, batch.transform);
    glBindVertexArray(geometryArray_);
    glBindBuffer(GL_ARRAY_BUFFER, geometryBuffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(batch.vertices.size_bytes()), batch.vertices.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(batch.vertices.size()));
}

void GlDevice::show(TargetHandle source, const Viewport& viewport) {
    setViewport(viewport);
    glDisable(GL_BLEND);  // software rendering takes a third of the time without blending
    glUseProgram(textureProgram_.name);
    glUniform1f(textureProgram_.up, flipped_ ? -1.0f : 1.0f);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, textures_[targetTexture(source).index].name);
    glBindVertexArray(emptyArray_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_BLEND);
}

Image GlDevice::readPixels(TargetHandle target) {
    const PixelSize size = target.index == 0 ? windowSize_ : textureSize(targetTexture(target));
    Image image{size.width, size.height, {}};
    image.rgba.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4);
    glBindFramebuffer(GL_FRAMEBUFFER, target.index == 0 ? 0 : targets_[target.index].name);
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    if (target.index == 0) flipRows(image);
    return image;
}

std::string GlDevice::description() const {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return std::string{value != nullptr ? reinterpret_cast<const char*>(value) : "unknown"};
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace plumb
