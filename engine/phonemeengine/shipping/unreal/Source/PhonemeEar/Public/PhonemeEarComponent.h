// SPDX-License-Identifier: MIT
#pragma once

#include "Components/ActorComponent.h"
#include "CoreMinimal.h"
#include "Templates/SharedPointer.h"

#include "PhonemeEarComponent.generated.h"

class FPhonemeStream;
class FPhonemeSubmixListener;
class USkeletalMeshComponent;
class USoundSubmix;

DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FPhonemeChanged, FName, Phoneme, FName, Viseme);

/** Where the sound comes from that a component recognises. */
UENUM(BlueprintType)
enum class EPhonemeSound : uint8
{
	/** The system's microphone. */
	Microphone,
	/** What is played through Submix. */
	Submix,
	/** What PushAudio is given. */
	Pushed
};

/** Recognises the phonemes of a voice, and moves the morph targets of all skeletal meshes of its actor by a mouth table. */
UCLASS(ClassGroup = (Audio), meta = (BlueprintSpawnableComponent))
class PHONEMEEAR_API UPhonemeEarComponent : public UActorComponent
{
	GENERATED_BODY()

public:
	UPhonemeEarComponent();

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Phoneme Ear")
	EPhonemeSound Sound = EPhonemeSound::Microphone;

	/** The submix of a voice; none stands for the main one. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Phoneme Ear")
	TObjectPtr<USoundSubmix> Submix;

	/** A mouth table that was shipped with the preset. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Phoneme Ear")
	FString Table = TEXT("arkit");

	/** Morph targets that have other names than the table's blend shapes, by the latter. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Phoneme Ear")
	TMap<FName, FName> MorphTargets;

	/** The value of a morph target for a whole movement. */
	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Phoneme Ear", meta = (ClampMin = "0", ClampMax = "2"))
	float Strength = 1.0f;

	/** The newest frame: names such as "a" and "aa"; 0..1; 0..1, or below 0 where the preset tells no confidence. */
	UPROPERTY(BlueprintReadOnly, Category = "Phoneme Ear")
	FName Phoneme;
	UPROPERTY(BlueprintReadOnly, Category = "Phoneme Ear")
	FName Viseme;
	UPROPERTY(BlueprintReadOnly, Category = "Phoneme Ear")
	float Intensity = 0.0f;
	UPROPERTY(BlueprintReadOnly, Category = "Phoneme Ear")
	float Confidence = -1.0f;

	/** The mouth shape of the newest frame, such as "B" of the table "rhubarb": for drawings. */
	UPROPERTY(BlueprintReadOnly, Category = "Phoneme Ear")
	FName Shape;

	/** How likely each viseme is in the newest frame, in the order sil, PP, FF, ...; all 0 where the preset tells none apart. */
	UPROPERTY(BlueprintReadOnly, Category = "Phoneme Ear")
	TArray<float> VisemeScores;

	UPROPERTY(BlueprintAssignable, Category = "Phoneme Ear")
	FPhonemeChanged OnPhonemeChanged;

	/** Begin; the component does so itself when the game begins. What is wrong is logged, and the component stops. */
	UFUNCTION(BlueprintCallable, Category = "Phoneme Ear")
	void Start();

	/** Stop, and release microphone and memory. */
	UFUNCTION(BlueprintCallable, Category = "Phoneme Ear")
	void Stop();

	/** Take interleaved samples of a voice, with full scale 1, where Sound is Pushed. */
	UFUNCTION(BlueprintCallable, Category = "Phoneme Ear")
	void PushAudio(const TArray<float>& Samples, int32 NumChannels, int32 SampleRate);

	/** The weights of the table's blend shapes now, 0..1, by name. */
	UFUNCTION(BlueprintCallable, Category = "Phoneme Ear")
	TMap<FName, float> GetWeights() const;

	virtual void BeginPlay() override;
	virtual void EndPlay(const EEndPlayReason::Type EndPlayReason) override;
	virtual void TickComponent(float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;

private:
	void FindTargets();
	void Fail(const FString& Why);
	FString Listen();

	TSharedPtr<FPhonemeStream, ESPMode::ThreadSafe> Stream;
	TSharedPtr<FPhonemeSubmixListener, ESPMode::ThreadSafe> Listener;

	/** What moves, and for each of the table's blend shapes its morph target, or none. */
	TArray<TPair<TWeakObjectPtr<USkeletalMeshComponent>, TArray<FName>>> Moved;
};
