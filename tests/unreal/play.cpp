// SPDX-License-Identifier: MIT
// Runs the plugin for Unreal without Unreal: play PLUGIN SOUND, with stereo float32 of 44.1 kHz on the standard input. SOUND
// is microphone, submix, pushed or live-link. Answers are float64: for each 10 ms the weights of the mesh, or of the subject.
#include "PhonemeEarComponent.h"
#include "PhonemeLiveLink.h"

#include <cstring>

namespace
{
	constexpr int32 Rate = 44100, Block = Rate / 100;
	const char* const Shapes[] = {"jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "Smile"};

	void Write(double Value) { std::fwrite(&Value, sizeof Value, 1, stdout); }

	std::vector<float> ReadSound()
	{
		std::vector<float> Samples;
		for (float Sample; std::fread(&Sample, sizeof Sample, 1, stdin) == 1;) Samples.push_back(Sample);
		return Samples;
	}

	void Give(const std::string& Sound, UPhonemeEarComponent* Component, float* Samples)
	{
		UAudioCapture* Microphone = NewObject<UAudioCapture>();
		if (Sound == "submix")
		{
			if (TheDevice.Listener) TheDevice.Listener->OnNewSubmixBuffer(nullptr, Samples, 2 * Block, 2, Rate, 0);
		}
		else if (Sound == "pushed") Component->PushAudio(TArray<float>(Samples, 2 * Block), 2, Rate);
		else if (Microphone->Delegate) Microphone->Delegate(Samples, 2 * Block);
	}

	int PlayLiveLink(std::vector<float>& Samples)
	{
		ILiveLinkClient Client;
		const UPhonemeLiveLinkSourceFactory Factory;
		TSharedPtr<ILiveLinkSource> Source = Factory.CreateSource("");
		Source->ReceiveClient(&Client, FGuid());
		for (std::size_t At = 0; At + 2 * Block <= Samples.size(); At += 2 * Block)
		{
			Give("live-link", nullptr, &Samples[At]);
			Source->Update();
			for (const char* Shape : Shapes)
			{
				double Weight = 0;
				for (int32 K = 0; K < Client.Values.Num(); K++) if (Client.Names[K] == FName(Shape)) Weight = Client.Values[K];
				Write(Weight);
			}
		}
		FPlatformTime::Later = 10;
		Source->Update();
		std::fprintf(stderr, "%s\n", *Source->GetSourceStatus().ToString());
		return Source->IsSourceStillValid() || !Source->RequestSourceShutdown();
	}
}

int main(int, char** Words)
{
	FPlugin::Folder = Words[1];
	const std::string Sound = Words[2];
	std::vector<float> Samples = ReadSound();
	if (Sound == "live-link") return PlayLiveLink(Samples);
	UAudioCapture::bIsThere = Sound != "none";
	AActor Actor;
	USkeletalMeshComponent Mesh, Bare;
	for (const char* Shape : Shapes) Mesh.Targets[Shape] = 0;
	Actor.Meshes = {&Bare, &Mesh};
	if (Sound == "bare") Actor.Meshes = {&Bare};
	UPhonemeEarComponent Component;
	Component.Owner = &Actor;
	Component.Table = Sound == "table" ? "mine" : "arkit";
	Component.MorphTargets.Add("mouthSmileLeft", "Smile");
	Component.Sound = Sound == "submix" ? EPhonemeSound::Submix : Sound == "pushed" ? EPhonemeSound::Pushed : EPhonemeSound::Microphone;
	int Changes = 0;
	Component.OnPhonemeChanged.Bound = [&](FName, FName) { Changes++; };
	Component.BeginPlay();
	for (std::size_t At = 0; At + 2 * Block <= Samples.size(); At += 2 * Block)
	{
		Give(Sound, &Component, &Samples[At]);
		Component.TickComponent(0.01f, LEVELTICK_All, nullptr);
		for (const char* Shape : Shapes) Write(Mesh.Targets[Shape]);
	}
	FPlatformTime::Later = 10;
	Component.TickComponent(0.01f, LEVELTICK_All, nullptr);
	Component.EndPlay(EEndPlayReason::Destroyed);
	std::fprintf(stderr, "changes %d\n", Changes);
	return NewObject<UAudioCapture>()->bIsCapturing || TheDevice.Listener;
}
