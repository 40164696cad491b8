#pragma once

#include <vulkan/vulkan.h>

#include "radv.hpp"
#include "spirv.hpp"

namespace nacre::bench {

/// RADV as a compiler: graphics pipelines are made for their statistics, nothing is drawn.
class VulkanCompiler {
public:
    /// Takes the first RADV device there is.
    static Result<VulkanCompiler> create();
    ~VulkanCompiler();
    VulkanCompiler(VulkanCompiler&& other) noexcept;
    VulkanCompiler(const VulkanCompiler&) = delete;
    VulkanCompiler& operator=(const VulkanCompiler&) = delete;
    VulkanCompiler& operator=(VulkanCompiler&&) = delete;

    const std::string& deviceName() const { return deviceName_; }

    /// uniformBlocks bindings of blocks come first, then tables bindings of samplers.
    Result<RadvStatistics> fragmentStatistics(const Spirv& vertex, const Spirv& fragment, std::uint32_t uniformBlocks,
                                              std::uint32_t tables) const;

private:
    VulkanCompiler() = default;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkRenderPass renderPass_ = VK_NULL_HANDLE;
    std::string deviceName_;

    Result<VkPipeline> makePipeline(VkPipelineLayout layout, VkShaderModule vertex, VkShaderModule fragment) const;
    Result<RadvStatistics> read(VkPipeline pipeline) const;
    RadvStatistics readStatistics(const VkPipelineExecutableInfoKHR& executable) const;
    std::string readAssembly(const VkPipelineExecutableInfoKHR& executable) const;
};

}  // namespace nacre::bench
