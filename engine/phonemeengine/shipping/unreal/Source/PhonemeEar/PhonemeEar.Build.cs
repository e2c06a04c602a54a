// SPDX-License-Identifier: MIT
using UnrealBuildTool;

public class PhonemeEar : ModuleRules
{
	public PhonemeEar(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
		PublicDependencyModuleNames.AddRange(new[] { "Core", "CoreUObject", "Engine" });
		PrivateDependencyModuleNames.AddRange(new[] { "AudioCapture", "AudioMixer", "LiveLinkInterface", "Projects" });
		RuntimeDependencies.Add("$(PluginDir)/Resources/preset.ear", StagedFileType.UFS); // into the game, too
	}
}
