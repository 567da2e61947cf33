#include "picture_part.h"

#include <cstddef>

#include "raytracer/json/json_document.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/file_hash.h"
#include "raytracer/util/number.h"

namespace raytracer::commands {

std::string pictureOptions(const RenderArguments& arguments, const RenderOptions& options) {
    std::string text;
    const auto add = [&](const std::string& option) { text += (text.empty() ? "--" : " --") + option; };
    add("max-recursion " + std::to_string(options.max_recursion));
    add("samples " + std::to_string(options.samples));
    add("adaptive " + shortestNumber(options.adaptive));
    add("cutoff " + shortestNumber(options.cutoff));
    add("texture-filter " + arguments.textureFilter);
    add("precision " + arguments.precision);
    add("pass " + arguments.pass);
    if (!arguments.only.empty()) add("only " + arguments.only);
    if (arguments.opaque) add("opaque");
    for (const std::string& set : arguments.sets) add("set " + set);
    return text;
}

PicturePart parsePart(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto number = numberOf<int>(text.substr(0, slash));
    const auto count = numberOf<int>(slash == text.npos ? "" : text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count || *count > mostParts)
        throw usageError("--part: expected K/N, two whole numbers with 1 <= K <= N <= " +
                         std::to_string(mostParts) + ", found " + inQuotes(text));
    return {*number, *count};
}

std::string partName(const std::string& out, const PicturePart& part) {
    return out + ".part-" + std::to_string(part.number) + "-of-" + std::to_string(part.count);
}

PartHead partHead(const RenderArguments& arguments, const RenderOptions& options, const PicturePart& part,
                  const std::vector<std::string>& sceneFiles) {
    PartHead head;
    head.version = programVersion();
    head.scene = hashOfFiles(sceneFiles);
    head.options = pictureOptions(arguments, options);
    head.size = options.size;
    head.crop = options.crop;
    head.part = part;
    return head;
}

}  // namespace raytracer::commands
