// SPDX-License-Identifier: MIT
#include "PhonemeLiveLink.h"

#include "HAL/PlatformProcess.h"
#include "HAL/PlatformTime.h"
#include "ILiveLinkClient.h"
#include "LiveLinkTypes.h"
#include "Roles/LiveLinkBasicRole.h"

#define LOCTEXT_NAMESPACE "PhonemeEar"

namespace
{
	const TCHAR* const Subject = TEXT("PhonemeEar");
	const TCHAR* const ArKitTable = TEXT("arkit");
}

void FPhonemeLiveLinkSource::ReceiveClient(ILiveLinkClient* InClient, FGuid InSource)
{
	Client = InClient;
	Source = InSource;
	Trouble = Stream.Open(ArKitTable);
	if (Trouble.IsEmpty())
	{
		Trouble = Stream.StartMicrophone();
	}
	FLiveLinkStaticDataStruct StaticData(FLiveLinkBaseStaticData::StaticStruct());
	StaticData.Cast<FLiveLinkBaseStaticData>()->PropertyNames = Stream.Movestates;
	Client->PushSubjectStaticData_AnyThread({Source, Subject}, ULiveLinkBasicRole::StaticClass(), MoveTemp(StaticData));
}

void FPhonemeLiveLinkSource::Update()
{
	bool bIsNew = false;
	for (ear_frame Frame; Stream.Take(Frame);)
	{
		bIsNew = true;
	}
	if (bIsNew && Client)
	{
		FLiveLinkFrameDataStruct FrameData(FLiveLinkBaseFrameData::StaticStruct());
		FLiveLinkBaseFrameData& Base = *FrameData.Cast<FLiveLinkBaseFrameData>();
		Base.WorldTime = FLiveLinkWorldTime(FPlatformTime::Seconds());
		Base.PropertyValues = Stream.Weights();
		Client->PushSubjectFrameData_AnyThread({Source, Subject}, MoveTemp(FrameData));
	}
	if (Trouble.IsEmpty())
	{
		Trouble = Stream.Trouble();
	}
}

bool FPhonemeLiveLinkSource::IsSourceStillValid() const
{
	return Client != nullptr && Trouble.IsEmpty();
}

bool FPhonemeLiveLinkSource::RequestSourceShutdown()
{
	Stream.Close();
	Client = nullptr;
	return true;
}

FText FPhonemeLiveLinkSource::GetSourceType() const
{
	return LOCTEXT("Type", "Phoneme Ear");
}

FText FPhonemeLiveLinkSource::GetSourceMachineName() const
{
	return FText::FromString(FPlatformProcess::ComputerName());
}

FText FPhonemeLiveLinkSource::GetSourceStatus() const
{
	return Trouble.IsEmpty() ? LOCTEXT("Active", "Active") : FText::FromString(Trouble);
}

FText UPhonemeLiveLinkSourceFactory::GetSourceDisplayName() const
{
	return LOCTEXT("Name", "Phoneme Ear (microphone)");
}

FText UPhonemeLiveLinkSourceFactory::GetSourceTooltip() const
{
	return LOCTEXT("Tooltip", "Moves the blend shapes of ARKit by the voice in the microphone");
}

TSharedPtr<ILiveLinkSource> UPhonemeLiveLinkSourceFactory::CreateSource(const FString&) const
{
	return MakeShared<FPhonemeLiveLinkSource>();
}

#undef LOCTEXT_NAMESPACE
