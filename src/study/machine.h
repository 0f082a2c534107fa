#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

/// The machine of a study.
namespace ajar::study {

/// Name of the processor, "unknown" if the system does not say.
std::string processor_model();
/// Processes that wanted to run, mean of the last minute; negative if unknown.
double load_average();
/// `processor`, `cores` (threads of the hardware), `memory_bytes`, `version`, `program_hash` (of
/// the program's file: two builds of one version differ in it).
nlohmann::ordered_json machine_json();

/// 64-bit FNV-1a as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

}  // namespace ajar::study
