#include "vulkan_compiler.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "vector_cycles.hpp"

namespace nacre::bench {
namespace {

Error failed(const char* what, VkResult result)
{
    return {std::string(what) + " failed: VkResult " + std::to_string(result)};
}

// All that a Vulkan call lists, by its usual two calls.
template <class Item, class List>
std::vector<Item> listed(const Item& empty, List&& list)
{
    std::uint32_t count = 0;
    list(&count, static_cast<Item*>(nullptr));
    std::vector<Item> items(count, empty);
    list(&count, items.data());
    items.resize(count);
    return items;
}

// A function of VK_KHR_pipeline_executable_properties, with which the device was made.
template <class Function>
Function find(VkDevice device, const char* name)
{
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device, name));
}

VkShaderModule makeModule(VkDevice device, const Spirv& words)
{
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size() * sizeof(std::uint32_t);
    info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    vkCreateShaderModule(device, &info, nullptr, &module);
    return module;
}

VkDescriptorSetLayout makeSetLayout(VkDevice device, std::uint32_t uniformBlocks, std::uint32_t tables)
{
    std::vector<VkDescriptorSetLayoutBinding> bindings(uniformBlocks + tables);
    for (std::uint32_t i = 0; i < bindings.size(); ++i) {
        bindings[i].binding = i;
        bindings[i].descriptorCount = 1;
        bindings[i].stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
        bindings[i].descriptorType = i < uniformBlocks ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    }
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    vkCreateDescriptorSetLayout(device, &info, nullptr, &layout);
    return layout;
}

VkPipelineLayout makePipelineLayout(VkDevice device, const VkDescriptorSetLayout& set)
{
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    vkCreatePipelineLayout(device, &info, nullptr, &layout);
    return layout;
}

VkRenderPass makeRenderPass(VkDevice device)
{
    VkAttachmentDescription picture{};
    picture.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    picture.samples = VK_SAMPLE_COUNT_1_BIT;
    picture.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    picture.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &picture;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass renderPass = VK_NULL_HANDLE;
    vkCreateRenderPass(device, &info, nullptr, &renderPass);
    return renderPass;
}

Result<VkDevice> makeDevice(VkPhysicalDevice physicalDevice)
{
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executable{};
    executable.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    executable.pipelineExecutableInfo = VK_TRUE;
    const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &executable;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    VkDevice device = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateDevice(physicalDevice, &info, nullptr, &device)) return failed("vkCreateDevice", result);
    return device;
}

}  // namespace

Result<VulkanCompiler> VulkanCompiler::create()
{
    VulkanCompiler compiler;
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    if (const VkResult result = vkCreateInstance(&info, nullptr, &compiler.instance_)) return failed("vkCreateInstance", result);

    const auto devices = listed<VkPhysicalDevice>(VK_NULL_HANDLE, [&](std::uint32_t* count, VkPhysicalDevice* items) {
        vkEnumeratePhysicalDevices(compiler.instance_, count, items);
    });
    for (VkPhysicalDevice device : devices) {
        VkPhysicalDeviceProperties properties{};
        vkGetPhysicalDeviceProperties(device, &properties);
        compiler.deviceName_ = properties.deviceName;
        if (compiler.deviceName_.find("RADV") == std::string::npos) continue;
        compiler.physicalDevice_ = device;
        break;
    }
    if (!compiler.physicalDevice_) {
        return Error{"no RADV device among " + std::to_string(devices.size()) + " (Debian: mesa-vulkan-drivers)"};
    }
    Result<VkDevice> device = makeDevice(compiler.physicalDevice_);
    if (!device) return device.error();
    compiler.device_ = *device;
    compiler.renderPass_ = makeRenderPass(compiler.device_);
    return compiler;
}

VulkanCompiler::VulkanCompiler(VulkanCompiler&& other) noexcept
    : instance_(std::exchange(other.instance_, nullptr)),
      physicalDevice_(other.physicalDevice_),
      device_(std::exchange(other.device_, nullptr)),
      renderPass_(other.renderPass_),
      deviceName_(std::move(other.deviceName_))
{
}

VulkanCompiler::~VulkanCompiler()
{
    if (device_) {
        vkDestroyRenderPass(device_, renderPass_, nullptr);
        vkDestroyDevice(device_, nullptr);
    }
    if (instance_) vkDestroyInstance(instance_, nullptr);
}

Result<VkPipeline> VulkanCompiler::makePipeline(VkPipelineLayout layout, VkShaderModule vertex, VkShaderModule fragment) const
{
    std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
    for (VkPipelineShaderStageCreateInfo& stage : stages) {
        stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stage.pName = "main";
    }
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = vertex;
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = fragment;

    VkPipelineVertexInputStateCreateInfo vertexInput{};
    vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    const VkViewport viewport{0.0F, 0.0F, 1024.0F, 1024.0F, 0.0F, 1.0F};
    const VkRect2D scissor{{0, 0}, {1024, 1024}};
    VkPipelineViewportStateCreateInfo viewports{};
    viewports.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewports.viewportCount = viewports.scissorCount = 1;
    viewports.pViewports = &viewport;
    viewports.pScissors = &scissor;
    VkPipelineRasterizationStateCreateInfo rasterization{};
    rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    rasterization.lineWidth = 1.0F;
    VkPipelineMultisampleStateCreateInfo multisample{};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineColorBlendAttachmentState allChannels{};
    allChannels.colorWriteMask = 15;
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = 1;
    blend.pAttachments = &allChannels;

    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR | VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &vertexInput;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewports;
    info.pRasterizationState = &rasterization;
    info.pMultisampleState = &multisample;
    info.pColorBlendState = &blend;
    info.layout = layout;
    info.renderPass = renderPass_;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    if (result != VK_SUCCESS) return failed("vkCreateGraphicsPipelines", result);
    return pipeline;
}

RadvStatistics VulkanCompiler::readStatistics(const VkPipelineExecutableInfoKHR& executable) const
{
    const auto statistics = find<PFN_vkGetPipelineExecutableStatisticsKHR>(device_, "vkGetPipelineExecutableStatisticsKHR");
    VkPipelineExecutableStatisticKHR empty{};
    empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
    const auto all = listed(empty, [&](std::uint32_t* count, VkPipelineExecutableStatisticKHR* items) {
        statistics(device_, &executable, count, items);
    });
    RadvStatistics found;
    const std::pair<std::string_view, std::uint64_t*> wanted[] = {
        {"Instructions", &found.instructions}, {"VGPRs", &found.vgprs},     {"SGPRs", &found.sgprs},
        {"Code size", &found.codeSize},        {"Latency", &found.latency}, {"Inverse Throughput", &found.inverseThroughput}};
    for (const VkPipelineExecutableStatisticKHR& one : all) {
        for (const auto& [name, target] : wanted) {
            if (name == one.name) *target = one.value.u64;
        }
    }
    return found;
}

std::string VulkanCompiler::readAssembly(const VkPipelineExecutableInfoKHR& executable) const
{
    const auto representations = find<PFN_vkGetPipelineExecutableInternalRepresentationsKHR>(
        device_, "vkGetPipelineExecutableInternalRepresentationsKHR");
    VkPipelineExecutableInternalRepresentationKHR empty{};
    empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR;
    auto all = listed(empty, [&](std::uint32_t* count, VkPipelineExecutableInternalRepresentationKHR* items) {
        representations(device_, &executable, count, items);
    });
    // The first call told the sizes, this one writes the texts.
    std::vector<std::string> texts;
    for (const auto& one : all) texts.emplace_back(one.dataSize, '\0');
    for (std::size_t i = 0; i < all.size(); ++i) all[i].pData = texts[i].data();
    auto count = static_cast<std::uint32_t>(all.size());
    representations(device_, &executable, &count, all.data());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::string_view(all[i].name) == "Assembly") return texts[i];
    }
    return {};
}

Result<RadvStatistics> VulkanCompiler::read(VkPipeline pipeline) const
{
    const auto executables = find<PFN_vkGetPipelineExecutablePropertiesKHR>(device_, "vkGetPipelineExecutablePropertiesKHR");
    VkPipelineInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR;
    info.pipeline = pipeline;
    VkPipelineExecutablePropertiesKHR empty{};
    empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
    const auto stages = listed(empty, [&](std::uint32_t* count, VkPipelineExecutablePropertiesKHR* items) {
        executables(device_, &info, count, items);
    });
    const auto isFragment = [](const VkPipelineExecutablePropertiesKHR& stage) {
        return (stage.stages & VK_SHADER_STAGE_FRAGMENT_BIT) != 0;
    };
    const auto fragment = std::find_if(stages.begin(), stages.end(), isFragment);
    if (fragment == stages.end()) return Error{"the driver reports no fragment shader"};

    VkPipelineExecutableInfoKHR executable{};
    executable.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
    executable.pipeline = pipeline;
    executable.executableIndex = static_cast<std::uint32_t>(fragment - stages.begin());
    RadvStatistics found = readStatistics(executable);
    if (found.inverseThroughput == 0) return Error{"the driver reports no inverse throughput"};
    const bool isRdna = deviceName_.find("NAVI") != std::string::npos || deviceName_.find("GFX1") != std::string::npos;
    found.vectorCycles = vectorCycles(readAssembly(executable), isRdna ? Architecture::rdna : Architecture::gcn);
    return found;
}

Result<RadvStatistics> VulkanCompiler::fragmentStatistics(const Spirv& vertex, const Spirv& fragment, std::uint32_t uniformBlocks,
                                                          std::uint32_t tables) const
{
    const VkDescriptorSetLayout set = makeSetLayout(device_, uniformBlocks, tables);
    const VkPipelineLayout layout = makePipelineLayout(device_, set);
    const VkShaderModule vertexModule = makeModule(device_, vertex), fragmentModule = makeModule(device_, fragment);
    Result<VkPipeline> pipeline = makePipeline(layout, vertexModule, fragmentModule);
    Result<RadvStatistics> found = pipeline ? read(*pipeline) : pipeline.error();
    if (pipeline) vkDestroyPipeline(device_, *pipeline, nullptr);
    vkDestroyShaderModule(device_, fragmentModule, nullptr);
    vkDestroyShaderModule(device_, vertexModule, nullptr);
    vkDestroyPipelineLayout(device_, layout, nullptr);
    vkDestroyDescriptorSetLayout(device_, set, nullptr);
    return found;
}

}  // namespace nacre::bench
