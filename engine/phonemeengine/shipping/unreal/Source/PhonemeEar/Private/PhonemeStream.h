// SPDX-License-Identifier: MIT
#pragma once

#include "AudioCapture.h"
#include "Containers/CircularQueue.h"
#include "CoreMinimal.h"
#include "HAL/CriticalSection.h"
#include "UObject/StrongObjectPtr.h"
#include <atomic>

#include "ear.h"

/**
 * A stream of sound that is recognised, and the mouth that moves by it. Push may be called in any one thread, such as that
 * of the sound, where it allocates only when the sample rate changes; all else belongs to the thread of the game.
 */
class FPhonemeStream
{
public:
	~FPhonemeStream();

	/** Open the plugin's preset, with one of its mouth tables. Return what is wrong, in a sentence; empty where nothing is. */
	FString Open(const FString& Table);

	/** Begin to recognise the system's microphone; returns as Open does. */
	FString StartMicrophone();

	/** Release everything. What is pushed afterwards is ignored. */
	void Close();

	/** Take NumFrames samples of each channel, interleaved, with full scale 1. */
	void Push(const float* Samples, int32 NumFrames, int32 NumChannels, int32 SampleRate);

	/** Give the oldest frame that was not taken yet, and move the mouth by it; false where there is none. */
	bool Take(ear_frame& Frame);

	/** What keeps it from recognising since it was opened, in a sentence; empty where nothing does. */
	FString Trouble() const;

	/** The weights of Movestates now, 0..1. */
	const TArray<float>& Weights();

	/** The names of a frame's viseme, and of its shape in the table, such as "B". */
	FName VisemeOf(const ear_frame& Frame) const;
	FName ShapeOf(const ear_frame& Frame) const;

	/** How many visemes the preset tells apart. */
	int32 NumVisemes() const { return ear_model_visemes(Model); }

	/** The blend shapes that the table moves. */
	TArray<FName> Movestates;

private:
	bool Reopen(int32 SampleRate);

	FCriticalSection Opening; // held while a recogniser is opened, closed or fed
	TCircularQueue<ear_frame> Frames{256};
	ear_frame Found[EAR_MOST_FRAMES(1024, EAR_LOWEST_RATE)];
	std::atomic<int32> Result{EAR_OK};
	std::atomic<double> LastPush{0.0}; // seconds
	ear_model* Model = nullptr;
	ear* Recogniser = nullptr;
	ear_mouth* Mouth = nullptr;
	int32 TableNumber = 0;
	int32 Rate = 0;
	double Time = 0.0; // of the newest frame, seconds
	TArray<float> MouthWeights;
	TStrongObjectPtr<UAudioCapture> Microphone;
	FAudioGeneratorHandle MicrophoneHandle;
};
