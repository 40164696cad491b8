#include "gpu_scene.hpp"

#include <string>
#include <utility>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace nacre::demo {

NoiseSpace noiseSpace(const Scene& scene)
{
    const float radius = 0.5F * glm::length(scene.bounds.most - scene.bounds.least);
    return {0.5F * (scene.bounds.least + scene.bounds.most), radius > 0.0F ? radius : 1.0F};
}

Result<GpuScene> GpuScene::upload(const GlFunctions& gl, Scene scene)
{
    GpuScene uploaded(gl);
    for (const nacre::demo::Mesh& source : scene.meshes) {
        Mesh mesh;
        mesh.count = static_cast<GLsizei>(source.indices.size());
        gl.GenVertexArrays(1, &mesh.vertexArray);
        gl.GenBuffers(1, &mesh.vertices);
        gl.GenBuffers(1, &mesh.indices);
        gl.BindVertexArray(mesh.vertexArray);
        gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(source.vertices.size() * sizeof(Vertex)), source.vertices.data(),
                      GL_STATIC_DRAW);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(source.indices.size() * sizeof(std::uint32_t)),
                      source.indices.data(), GL_STATIC_DRAW);
        const auto attribute = [&](GLuint location, GLint size, std::size_t offset) {
            gl.EnableVertexAttribArray(location);
            gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
        };
        attribute(0, 3, offsetof(Vertex, position));
        attribute(1, 3, offsetof(Vertex, normal));
        attribute(2, 4, offsetof(Vertex, tangent));
        gl.BindVertexArray(0);
        uploaded.meshes_.push_back(mesh);
    }
    if (const GLenum error = gl.GetError()) return Error{"OpenGL error " + std::to_string(error) + " while uploading the model"};
    uploaded.scene_ = std::move(scene);
    return uploaded;
}

GpuScene::GpuScene(GpuScene&& other) noexcept
    : gl_(other.gl_), meshes_(std::exchange(other.meshes_, {})), scene_(std::move(other.scene_))
{
}

GpuScene& GpuScene::operator=(GpuScene&& other) noexcept
{
    std::swap(gl_, other.gl_);
    std::swap(meshes_, other.meshes_);
    std::swap(scene_, other.scene_);
    return *this;
}

GpuScene::~GpuScene()
{
    for (const Mesh& mesh : meshes_) {
        gl_->DeleteVertexArrays(1, &mesh.vertexArray);
        gl_->DeleteBuffers(1, &mesh.vertices);
        gl_->DeleteBuffers(1, &mesh.indices);
    }
}

void GpuScene::draw(GLuint program) const
{
    const GlFunctions& gl = *gl_;
    const auto at = [&](const char* name) { return gl.GetUniformLocation(program, name); };
    const NoiseSpace noise = noiseSpace(scene_);
    gl.Uniform3fv(at("sceneCentre"), 1, glm::value_ptr(noise.centre));
    gl.Uniform1f(at("sceneRadius"), noise.radius);
    const GLint objectToWorld = at("objectToWorld"), normalToWorld = at("normalToWorld");
    for (const Instance& instance : scene_.instances) {
        const Mesh& mesh = meshes_[instance.mesh];
        const glm::mat3 linear(instance.objectToWorld);
        gl.UniformMatrix4fv(objectToWorld, 1, GL_FALSE, glm::value_ptr(instance.objectToWorld));
        gl.UniformMatrix3fv(normalToWorld, 1, GL_FALSE, glm::value_ptr(glm::inverseTranspose(linear)));
        gl.FrontFace(isMirrored(instance) ? GL_CW : GL_CCW);
        gl.BindVertexArray(mesh.vertexArray);
        gl.DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
    }
    gl.BindVertexArray(0);
}

}  // namespace nacre::demo
