// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "ILiveLinkSource.h"
#include "LiveLinkSourceFactory.h"

#include "PhonemeStream.h"

#include "PhonemeLiveLink.generated.h"

/** Sends the blend shapes of ARKit by the microphone, as the subject PhonemeEar: for MetaHumans, in the editor as well. */
class FPhonemeLiveLinkSource final : public ILiveLinkSource
{
public:
	virtual void ReceiveClient(ILiveLinkClient* InClient, FGuid InSource) override;
	virtual void Update() override;
	virtual bool IsSourceStillValid() const override;
	virtual bool RequestSourceShutdown() override;
	virtual FText GetSourceType() const override;
	virtual FText GetSourceMachineName() const override;
	virtual FText GetSourceStatus() const override;

private:
	FPhonemeStream Stream;
	ILiveLinkClient* Client = nullptr;
	FGuid Source;
	FString Trouble;
};

/** Puts the source into the menu of the Live Link window. */
UCLASS()
class UPhonemeLiveLinkSourceFactory : public ULiveLinkSourceFactory
{
	GENERATED_BODY()

public:
	virtual FText GetSourceDisplayName() const override;
	virtual FText GetSourceTooltip() const override;
	virtual EMenuType GetMenuType() const override { return EMenuType::MenuEntry; }
	virtual TSharedPtr<ILiveLinkSource> CreateSource(const FString& ConnectionString) const override;
};
