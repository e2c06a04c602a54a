// SPDX-License-Identifier: MIT
#include "PhonemeEarComponent.h"

#include "AudioDevice.h"
#include "AudioDeviceManager.h"
#include "Components/SkeletalMeshComponent.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "ISubmixBufferListener.h"
#include "Modules/ModuleManager.h"
#include "Sound/SoundSubmix.h"

#include "PhonemeStream.h"

DEFINE_LOG_CATEGORY_STATIC(LogPhonemeEar, Log, All);
IMPLEMENT_MODULE(FDefaultModuleImpl, PhonemeEar)

/** Hands what is played through a submix to a stream, in the thread of the sound. */
class FPhonemeSubmixListener final : public ISubmixBufferListener
{
public:
	FPhonemeSubmixListener(TSharedRef<FPhonemeStream, ESPMode::ThreadSafe> InStream, FAudioDevice& InDevice, USoundSubmix& InSubmix)
		: Stream(InStream), Device(InDevice.DeviceID), Submix(&InSubmix) {}

	virtual void OnNewSubmixBuffer(const USoundSubmix*, float* Samples, int32 NumSamples, int32 NumChannels, const int32 SampleRate, double) override
	{
		Stream->Push(Samples, NumSamples / FMath::Max(NumChannels, 1), NumChannels, SampleRate);
	}

	virtual const FString& GetListenerName() const override
	{
		static const FString Name = TEXT("PhonemeEar");
		return Name;
	}

	const TSharedRef<FPhonemeStream, ESPMode::ThreadSafe> Stream;
	const Audio::FDeviceId Device;
	const TWeakObjectPtr<USoundSubmix> Submix;
};

UPhonemeEarComponent::UPhonemeEarComponent()
{
	PrimaryComponentTick.bCanEverTick = true;
}

void UPhonemeEarComponent::BeginPlay()
{
	Super::BeginPlay();
	Start();
}

void UPhonemeEarComponent::EndPlay(const EEndPlayReason::Type EndPlayReason)
{
	Stop();
	Super::EndPlay(EndPlayReason);
}

void UPhonemeEarComponent::Start()
{
	Stop();
	Stream = MakeShared<FPhonemeStream, ESPMode::ThreadSafe>();
	FString Why = Stream->Open(Table);
	if (Why.IsEmpty())
	{
		FindTargets();
		Why = Listen();
	}
	if (!Why.IsEmpty())
	{
		Fail(Why);
	}
}

FString UPhonemeEarComponent::Listen()
{
	if (Sound == EPhonemeSound::Microphone)
	{
		return Stream->StartMicrophone();
	}
	FAudioDevice* Device = Sound == EPhonemeSound::Submix && GetWorld() ? GetWorld()->GetAudioDeviceRaw() : nullptr;
	if (Device)
	{
		USoundSubmix& Heard = Submix ? *Submix : Device->GetMainSubmixObject();
		Listener = MakeShared<FPhonemeSubmixListener, ESPMode::ThreadSafe>(Stream.ToSharedRef(), *Device, Heard);
		Device->RegisterSubmixBufferListener(Listener.ToSharedRef(), Heard);
	}
	const bool bIsDeaf = Sound == EPhonemeSound::Submix && !Device;
	return bIsDeaf ? FString(TEXT("nothing is played, since there is no sound card; connect one")) : FString();
}

void UPhonemeEarComponent::Stop()
{
	if (Listener)
	{
		FAudioDeviceManager* Manager = FAudioDeviceManager::Get();
		FAudioDevice* Device = Manager ? Manager->GetAudioDeviceRaw(Listener->Device) : nullptr;
		if (Device && Listener->Submix.IsValid())
		{
			Device->UnregisterSubmixBufferListener(Listener.ToSharedRef(), *Listener->Submix);
		}
		Listener.Reset(); // the thread of the sound may hold it a little longer
	}
	if (Stream)
	{
		Stream->Close();
		Stream.Reset();
	}
	Moved.Reset();
}

void UPhonemeEarComponent::Fail(const FString& Why)
{
	UE_LOG(LogPhonemeEar, Error, TEXT("%s: %s"), *GetNameSafe(GetOwner()), *Why);
	Stop();
}

void UPhonemeEarComponent::FindTargets()
{
	TArray<USkeletalMeshComponent*> Meshes;
	GetOwner()->GetComponents(Meshes);
	for (USkeletalMeshComponent* Mesh : Meshes)
	{
		TArray<FName> Targets;
		bool bHasAny = false;
		for (const FName& Movestate : Stream->Movestates)
		{
			const FName* Other = MorphTargets.Find(Movestate);
			const FName Target = Other ? *Other : Movestate;
			const bool bHas = Mesh->FindMorphTarget(Target) != nullptr;
			Targets.Add(bHas ? Target : FName());
			bHasAny |= bHas;
		}
		if (bHasAny)
		{
			Moved.Emplace(Mesh, Targets);
		}
	}
	if (Moved.IsEmpty() && !Stream->Movestates.IsEmpty())
	{
		UE_LOG(LogPhonemeEar, Warning, TEXT("%s: no mesh has a morph target of the table %s, such as %s"),
			*GetNameSafe(GetOwner()), *Table, *Stream->Movestates[0].ToString());
	}
}

void UPhonemeEarComponent::PushAudio(const TArray<float>& Samples, int32 NumChannels, int32 SampleRate)
{
	if (Stream && Sound == EPhonemeSound::Pushed && NumChannels > 0)
	{
		Stream->Push(Samples.GetData(), Samples.Num() / NumChannels, NumChannels, SampleRate);
	}
}

TMap<FName, float> UPhonemeEarComponent::GetWeights() const
{
	TMap<FName, float> Weights;
	for (int32 K = 0; Stream && K < Stream->Movestates.Num(); K++)
	{
		Weights.Add(Stream->Movestates[K], Stream->Weights()[K]);
	}
	return Weights;
}

void UPhonemeEarComponent::TickComponent(float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction)
{
	Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
	if (!Stream)
	{
		return;
	}
	for (ear_frame Frame; Stream->Take(Frame);)
	{
		const FName Before = Phoneme;
		const FName VisemeBefore = Viseme;
		Phoneme = FName(UTF8_TO_TCHAR(ear_phoneme_name(Frame.phoneme)));
		Viseme = Stream->VisemeOf(Frame);
		Shape = Stream->ShapeOf(Frame);
		Intensity = Frame.intensity;
		Confidence = FMath::IsNaN(Frame.confidence) ? -1.0f : Frame.confidence;
		VisemeScores = TArray<float>(Frame.viseme_scores, Stream->NumVisemes());
		if (Phoneme != Before || Viseme != VisemeBefore)
		{
			OnPhonemeChanged.Broadcast(Phoneme, Viseme);
			if (!Stream)
			{
				return; // what was called has stopped it
			}
		}
	}
	const TArray<float>& Weights = Stream->Weights();
	for (const auto& Pair : Moved)
	{
		USkeletalMeshComponent* Mesh = Pair.Key.Get();
		for (int32 K = 0; Mesh && K < Weights.Num(); K++)
		{
			if (!Pair.Value[K].IsNone())
			{
				Mesh->SetMorphTarget(Pair.Value[K], Strength * Weights[K]);
			}
		}
	}
	const FString Why = Stream->Trouble();
	if (!Why.IsEmpty())
	{
		Fail(Why);
	}
}
