// SPDX-License-Identifier: MIT
#include "PhonemeStream.h"

#include "HAL/PlatformTime.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/FileHelper.h"
#include "Misc/Paths.h"
#include "Misc/ScopeLock.h"

namespace
{
	constexpr int32 MostSamples = 1024; // of each channel, that are recognised at once
	constexpr double LongestPause = 2.0; // seconds that a microphone may be silent before it counts as gone

	FString TextOf(int32 Code)
	{
		return UTF8_TO_TCHAR(ear_error_text(Code));
	}
}

FPhonemeStream::~FPhonemeStream()
{
	Close();
}

FString FPhonemeStream::Open(const FString& Table)
{
	Close();
	const FString Path = FPaths::Combine(IPluginManager::Get().FindPlugin(TEXT("PhonemeEar"))->GetBaseDir(), TEXT("Resources/preset.ear"));
	TArray<uint8> Bytes;
	if (!FFileHelper::LoadFileToArray(Bytes, *Path))
	{
		return Path + TEXT(" cannot be read; ship the plugin again");
	}
	int32 Code = ear_model_open(Bytes.GetData(), Bytes.Num(), nullptr, 0, &Model);
	TableNumber = Code == EAR_OK ? ear_table_find(Model, TCHAR_TO_UTF8(*Table)) : 0;
	if (TableNumber < 0)
	{
		Close();
		return TEXT("the preset has no mouth table ") + Table + TEXT("; ship it with --table");
	}
	if (Code == EAR_OK)
	{
		Code = ear_mouth_open(Model, TableNumber, 1, nullptr, 0, &Mouth);
	}
	if (Code != EAR_OK)
	{
		Close();
		return TextOf(Code);
	}
	for (int32 K = 0; K < ear_table_movestates(Model, TableNumber); K++)
	{
		Movestates.Add(FName(UTF8_TO_TCHAR(ear_table_movestate(Model, TableNumber, K))));
	}
	MouthWeights.SetNumZeroed(Movestates.Num());
	return FString();
}

FString FPhonemeStream::StartMicrophone()
{
	Microphone.Reset(NewObject<UAudioCapture>());
	if (!Microphone->OpenDefaultAudioStream())
	{
		Microphone.Reset();
		return TEXT("the microphone cannot be opened; connect one, and close other programs that may use it");
	}
	const int32 NumChannels = FMath::Max(Microphone->GetNumChannels(), 1);
	const int32 SampleRate = Microphone->GetSampleRate();
	MicrophoneHandle = Microphone->AddGeneratorDelegate([this, NumChannels, SampleRate](const float* Samples, int32 NumSamples)
	{
		Push(Samples, NumSamples / NumChannels, NumChannels, SampleRate);
	});
	LastPush = FPlatformTime::Seconds();
	Microphone->StartCapturingAudio();
	return FString();
}

void FPhonemeStream::Close()
{
	if (Microphone)
	{
		Microphone->StopCapturingAudio();
		Microphone->RemoveGeneratorDelegate(MicrophoneHandle); // and none is under way any more
		Microphone.Reset();
	}
	FScopeLock Lock(&Opening);
	ear_close(Recogniser);
	ear_mouth_close(Mouth);
	ear_model_close(Model);
	Recogniser = nullptr;
	Mouth = nullptr;
	Model = nullptr;
	Rate = 0;
	Time = 0.0;
	Result = EAR_OK;
	Movestates.Reset();
	MouthWeights.Reset();
	for (ear_frame Old; Frames.Dequeue(Old);) {}
}

void FPhonemeStream::Push(const float* Samples, int32 NumFrames, int32 NumChannels, int32 SampleRate)
{
	LastPush = FPlatformTime::Seconds();
	FScopeLock Lock(&Opening); // free, but while it is opened or closed
	if (!Model || Result != EAR_OK || (SampleRate != Rate && !Reopen(SampleRate)))
	{
		return;
	}
	for (int32 N; NumFrames > 0; NumFrames -= N, Samples += N * NumChannels)
	{
		N = FMath::Min(NumFrames, MostSamples);
		size_t NumFound = 0;
		Result = ear_push_channels(Recogniser, Samples, N, NumChannels, Found, UE_ARRAY_COUNT(Found), &NumFound);
		for (size_t K = 0; K < NumFound; K++)
		{
			Frames.Enqueue(Found[K]); // a full queue, from which none were taken for seconds, drops it
		}
	}
}

/* Open a recogniser for another sample rate; the time begins anew. */
bool FPhonemeStream::Reopen(int32 SampleRate)
{
	ear_close(Recogniser);
	Recogniser = nullptr;
	Rate = SampleRate;
	Result = ear_open(Model, SampleRate, nullptr, 0, &Recogniser);
	return Result == EAR_OK;
}

bool FPhonemeStream::Take(ear_frame& Frame)
{
	if (!Frames.Dequeue(Frame))
	{
		return false;
	}
	Time += 0.01; // not the frame's number, which begins anew with each rate
	ear_mouth_hear(Mouth, Time, Frame.phoneme, Frame.viseme, Frame.intensity);
	return true;
}

FString FPhonemeStream::Trouble() const
{
	if (Microphone && FPlatformTime::Seconds() - LastPush > LongestPause)
	{
		return TEXT("the microphone was taken away; connect it, and start again");
	}
	return Result == EAR_OK ? FString() : TextOf(Result);
}

const TArray<float>& FPhonemeStream::Weights()
{
	if (Mouth)
	{
		ear_mouth_weights(Mouth, Time, MouthWeights.GetData());
	}
	return MouthWeights;
}

FName FPhonemeStream::VisemeOf(const ear_frame& Frame) const
{
	return Frame.viseme == EAR_NO_VISEME ? FName() : FName(UTF8_TO_TCHAR(ear_model_viseme(Model, Frame.viseme)));
}

FName FPhonemeStream::ShapeOf(const ear_frame& Frame) const
{
	const int32 Shape = ear_table_shape(Model, TableNumber, Frame.phoneme, Frame.viseme);
	return FName(UTF8_TO_TCHAR(ear_table_shape_name(Model, TableNumber, Shape)));
}
