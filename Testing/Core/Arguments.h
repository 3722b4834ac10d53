#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{

/// What a program that prints truths is asked for: `[reduced] [PART]... [OPTION VALUE]...`; without
/// names of parts, all of them.
class Arguments
{
public:
  using Words = std::vector<std::string>;

  /// Ends the program with a sentence if a word is neither a part nor an option with a value.
  Arguments(int count, char** words, Words parts, const Words& options = {})
    : parts_(std::move(parts))
  {
    for (int i = 1; i < count; ++i)
    {
      const std::string word = words[i];
      const bool isOption = contains(options, word);
      if (isOption ? i + 1 == count : word != "reduced" && !contains(this->parts_, word))
      {
        std::fprintf(stderr, "%s: expected reduced%s%s, found %s\n", words[0],
          listed(this->parts_, "").c_str(), listed(options, " VALUE").c_str(), word.c_str());
        std::exit(2);
      }
      this->found_[word] = isOption ? words[++i] : "";
    }
  }

  bool has(const std::string& word) const { return this->found_.count(word) != 0; }

  bool isReduced() const { return this->has("reduced"); }

  /// Whether a part is named, or none is.
  bool wants(const std::string& part) const
  {
    return this->has(part) ||
      std::none_of(this->parts_.begin(), this->parts_.end(),
        [this](const std::string& other) { return this->has(other); });
  }

  /// An option's value; empty without it.
  std::string valueOf(const std::string& option) const
  {
    return this->has(option) ? this->found_.at(option) : "";
  }

private:
  static bool contains(const Words& words, const std::string& word)
  {
    return std::find(words.begin(), words.end(), word) != words.end();
  }

  static std::string listed(const Words& words, const std::string& suffix)
  {
    std::string text;
    for (const std::string& word : words)
    {
      text += ", " + word + suffix;
    }
    return text;
  }

  Words parts_;
  std::map<std::string, std::string> found_; // and the options' values
};

} // namespace SurfaceScalars::Truth
