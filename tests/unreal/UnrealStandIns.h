// SPDX-License-Identifier: MIT
// Stand-ins for the classes and functions of Unreal Engine 5.4 that the plugin uses: enough to compile it, and to run it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#define UCLASS(...)
#define UENUM(...)
#define UPROPERTY(...)
#define UFUNCTION(...)
#define GENERATED_BODY() public: static UClass* StaticClass() { return nullptr; } private:
#define PHONEMEEAR_API
#define IMPLEMENT_MODULE(Class, Name)
#define DEFINE_LOG_CATEGORY_STATIC(...)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(Name, A, NameOfA, B, NameOfB) \
	struct Name { std::function<void(A, B)> Bound; void Broadcast(A First, B Second) const { if (Bound) Bound(First, Second); } }
#define UE_LOG(Category, Verbosity, ...) (std::fprintf(stderr, #Verbosity ": "), std::fprintf(stderr, __VA_ARGS__), std::fputc('\n', stderr))
#define UE_ARRAY_COUNT(Array) (sizeof(Array) / sizeof *(Array))
#define TEXT(Words) Words
#define LOCTEXT(Key, Words) FText::FromString(Words)
#define UTF8_TO_TCHAR(Words) (Words)
#define TCHAR_TO_UTF8(Words) (Words)

using TCHAR = char;
using uint8 = std::uint8_t;
using int32 = std::int32_t;

class UClass;

class FString
{
public:
	FString(const TCHAR* InWords = "") : Words(InWords) {}
	FString(std::string InWords) : Words(std::move(InWords)) {}
	const TCHAR* operator*() const { return Words.c_str(); }
	bool IsEmpty() const { return Words.empty(); }
	friend FString operator+(const FString& A, const FString& B) { return A.Words + B.Words; }

private:
	std::string Words;
};

class FName
{
public:
	FName() = default;
	FName(const TCHAR* InWords) : Words(InWords) {}
	bool IsNone() const { return Words.empty(); }
	FString ToString() const { return Words; }
	auto operator<=>(const FName&) const = default;

private:
	std::string Words;
};

class FText
{
public:
	static FText FromString(const FString& Words) { FText Made; Made.Words = Words; return Made; }
	const FString& ToString() const { return Words; }

private:
	FString Words;
};

template <typename T> class TArray
{
public:
	TArray() = default;
	TArray(const T* Values, int32 N) : Items(Values, Values + N) {}
	void Add(const T& Item) { Items.push_back(Item); }
	template <typename... Words> void Emplace(Words&&... Given) { Items.emplace_back(std::forward<Words>(Given)...); }
	int32 Num() const { return static_cast<int32>(Items.size()); }
	bool IsEmpty() const { return Items.empty(); }
	void Reset() { Items.clear(); }
	void SetNumZeroed(int32 N) { Items.assign(N, T()); }
	void SetNumUninitialized(int32 N) { Items.resize(N); }
	T* GetData() { return Items.data(); }
	const T* GetData() const { return Items.data(); }
	T& operator[](int32 K) { return Items.at(K); }
	const T& operator[](int32 K) const { return Items.at(K); }
	auto begin() { return Items.begin(); }
	auto end() { return Items.end(); }
	auto begin() const { return Items.begin(); }
	auto end() const { return Items.end(); }

private:
	std::vector<T> Items;
};

template <typename K, typename V> class TMap
{
public:
	void Add(const K& Key, const V& Value) { Items[Key] = Value; }
	const V* Find(const K& Key) const { auto At = Items.find(Key); return At == Items.end() ? nullptr : &At->second; }
	int32 Num() const { return static_cast<int32>(Items.size()); }

private:
	std::map<K, V> Items;
};

template <typename A, typename B> struct TPair
{
	TPair(const A& InKey, const B& InValue) : Key(InKey), Value(InValue) {}
	A Key;
	B Value;
};

enum class ESPMode { NotThreadSafe, ThreadSafe };
template <typename T, ESPMode = ESPMode::ThreadSafe> class TSharedRef : public std::shared_ptr<T>
{
public:
	template <typename U> explicit TSharedRef(std::shared_ptr<U> Given) : std::shared_ptr<T>(std::move(Given)) {}
	template <typename U> TSharedRef(const TSharedRef<U, ESPMode::ThreadSafe>& Given) : std::shared_ptr<T>(Given) {}
};
template <typename T, ESPMode = ESPMode::ThreadSafe> class TSharedPtr : public std::shared_ptr<T>
{
public:
	TSharedPtr() = default;
	template <typename U> TSharedPtr(const TSharedRef<U, ESPMode::ThreadSafe>& Given) : std::shared_ptr<T>(Given) {}
	TSharedRef<T> ToSharedRef() const { return TSharedRef<T>(std::shared_ptr<T>(*this)); }
	void Reset() { this->reset(); }
};
template <typename T, ESPMode = ESPMode::ThreadSafe, typename... Words> TSharedRef<T> MakeShared(Words&&... Given)
{
	return TSharedRef<T>(std::make_shared<T>(std::forward<Words>(Given)...));
}
template <typename T> using TObjectPtr = T*;
template <typename T> class TWeakObjectPtr
{
public:
	TWeakObjectPtr(T* InObject) : Object(InObject) {}
	T* Get() const { return Object; }
	bool IsValid() const { return Object != nullptr; }
	T& operator*() const { return *Object; }

private:
	T* Object;
};
template <typename T> class TStrongObjectPtr
{
public:
	void Reset(T* InObject = nullptr) { Object = InObject; }
	explicit operator bool() const { return Object != nullptr; }
	T* operator->() const { return Object; }

private:
	T* Object = nullptr;
};
template <typename T> T* NewObject() { static T Made; return &Made; }
template <typename T> std::remove_reference_t<T>&& MoveTemp(T&& Given) { return std::move(Given); }

using FCriticalSection = std::mutex;
struct FScopeLock : std::lock_guard<std::mutex> { explicit FScopeLock(std::mutex* Lock) : std::lock_guard<std::mutex>(*Lock) {} };
template <typename T> class TCircularQueue
{
public:
	explicit TCircularQueue(int32 InRoom) : Room(InRoom) {}
	bool Enqueue(const T& Item) { return Room > Items.size() && (Items.push(Item), true); }
	bool Dequeue(T& Item) { return !Items.empty() && (Item = Items.front(), Items.pop(), true); }

private:
	std::size_t Room;
	std::queue<T> Items;
};

struct FMath
{
	template <typename T> static T Max(T A, T B) { return std::max(A, B); }
	template <typename T> static T Min(T A, T B) { return std::min(A, B); }
	static bool IsNaN(float Value) { return std::isnan(Value); }
};
struct FPlatformTime
{
	static inline double Later = 0; // what tests add
	static double Seconds() { return Later + std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
};
struct FPlatformProcess { static const TCHAR* ComputerName() { return "machine"; } };
struct FPaths { static FString Combine(const FString& A, const FString& B) { return A + "/" + B; } };
struct FFileHelper
{
	static bool LoadFileToArray(TArray<uint8>& Bytes, const TCHAR* Path)
	{
		std::ifstream File(Path, std::ios::binary);
		for (std::istreambuf_iterator<char> At(File), End; At != End; ++At) Bytes.Add(static_cast<uint8>(*At));
		return static_cast<bool>(File);
	}
};
struct FPlugin { static inline FString Folder; FString GetBaseDir() const { return Folder; } };
struct IPluginManager
{
	static IPluginManager& Get() { static IPluginManager One; return One; }
	TSharedPtr<FPlugin> FindPlugin(const FString&) { return MakeShared<FPlugin>(); }
};

// Sound.

struct FAudioGeneratorHandle { int32 Id = 0; };
class UAudioCapture
{
public:
	static inline bool bIsThere = true;
	std::function<void(const float*, int32)> Delegate;
	bool bIsCapturing = false;
	bool OpenDefaultAudioStream() { return bIsThere; }
	void StartCapturingAudio() { bIsCapturing = true; }
	void StopCapturingAudio() { bIsCapturing = false; }
	int32 GetNumChannels() const { return 2; }
	int32 GetSampleRate() const { return 44100; }
	FAudioGeneratorHandle AddGeneratorDelegate(std::function<void(const float*, int32)> Function) { Delegate = std::move(Function); return {}; }
	void RemoveGeneratorDelegate(FAudioGeneratorHandle) { Delegate = nullptr; }
};
class USoundSubmix {};
class ISubmixBufferListener
{
public:
	virtual ~ISubmixBufferListener() = default;
	virtual void OnNewSubmixBuffer(const USoundSubmix*, float*, int32, int32, const int32, double) = 0;
	virtual const FString& GetListenerName() const = 0;
};
namespace Audio { using FDeviceId = unsigned; }
class FAudioDevice
{
public:
	Audio::FDeviceId DeviceID = 1;
	std::shared_ptr<ISubmixBufferListener> Listener;
	USoundSubmix Main;
	USoundSubmix& GetMainSubmixObject() { return Main; }
	void RegisterSubmixBufferListener(TSharedRef<ISubmixBufferListener> Given, USoundSubmix&) { Listener = Given; }
	void UnregisterSubmixBufferListener(TSharedRef<ISubmixBufferListener>, USoundSubmix&) { Listener.reset(); }
};
inline FAudioDevice TheDevice;
struct FAudioDeviceManager
{
	static FAudioDeviceManager* Get() { static FAudioDeviceManager One; return &One; }
	FAudioDevice* GetAudioDeviceRaw(Audio::FDeviceId) { return &TheDevice; }
};
struct UWorld { FAudioDevice* GetAudioDeviceRaw() { return &TheDevice; } };

// Actors.

class UMorphTarget {};
class USkeletalMeshComponent
{
public:
	std::map<FName, float> Targets;
	UMorphTarget Any;
	UMorphTarget* FindMorphTarget(FName Name) { return Targets.count(Name) ? &Any : nullptr; }
	void SetMorphTarget(FName Name, float Value) { Targets.at(Name) = Value; }
};
class AActor
{
public:
	std::vector<USkeletalMeshComponent*> Meshes;
	void GetComponents(TArray<USkeletalMeshComponent*>& Found) { for (auto* Mesh : Meshes) Found.Add(Mesh); }
};
inline FString GetNameSafe(AActor*) { return "Actor"; }
enum ELevelTick { LEVELTICK_All };
struct EEndPlayReason { enum Type { Destroyed }; };
struct FActorComponentTickFunction { bool bCanEverTick = false; };
class UActorComponent
{
public:
	using Super = UActorComponent;
	AActor* Owner = nullptr;
	FActorComponentTickFunction PrimaryComponentTick;
	AActor* GetOwner() const { return Owner; }
	UWorld* GetWorld() const { static UWorld One; return &One; }
	virtual ~UActorComponent() = default;
	virtual void BeginPlay() {}
	virtual void EndPlay(const EEndPlayReason::Type) {}
	virtual void TickComponent(float, ELevelTick, FActorComponentTickFunction*) {}
};

// Live Link.

struct FGuid {};
struct FLiveLinkSubjectKey { FGuid Source; FName Name; };
struct FLiveLinkWorldTime { FLiveLinkWorldTime(double = 0) {} };
struct FLiveLinkBaseStaticData { TArray<FName> PropertyNames; static UClass* StaticStruct() { return nullptr; } };
struct FLiveLinkBaseFrameData { FLiveLinkWorldTime WorldTime; TArray<float> PropertyValues; static UClass* StaticStruct() { return nullptr; } };
template <typename T> struct FLiveLinkData { explicit FLiveLinkData(UClass*) {} T Data; template <typename U> U* Cast() { return &Data; } };
using FLiveLinkStaticDataStruct = FLiveLinkData<FLiveLinkBaseStaticData>;
using FLiveLinkFrameDataStruct = FLiveLinkData<FLiveLinkBaseFrameData>;
struct ULiveLinkBasicRole { static UClass* StaticClass() { return nullptr; } };
class ILiveLinkClient
{
public:
	TArray<FName> Names;
	TArray<float> Values;
	void PushSubjectStaticData_AnyThread(const FLiveLinkSubjectKey&, UClass*, FLiveLinkStaticDataStruct&& Given) { Names = Given.Data.PropertyNames; }
	void PushSubjectFrameData_AnyThread(const FLiveLinkSubjectKey&, FLiveLinkFrameDataStruct&& Given) { Values = Given.Data.PropertyValues; }
};
class ILiveLinkSource
{
public:
	virtual ~ILiveLinkSource() = default;
	virtual void ReceiveClient(ILiveLinkClient*, FGuid) = 0;
	virtual void Update() {}
	virtual bool IsSourceStillValid() const = 0;
	virtual bool RequestSourceShutdown() = 0;
	virtual FText GetSourceType() const = 0;
	virtual FText GetSourceMachineName() const = 0;
	virtual FText GetSourceStatus() const = 0;
};
class ULiveLinkSourceFactory
{
public:
	enum class EMenuType { SubPanel, MenuEntry, Disabled };
	virtual ~ULiveLinkSourceFactory() = default;
	virtual FText GetSourceDisplayName() const = 0;
	virtual FText GetSourceTooltip() const = 0;
	virtual EMenuType GetMenuType() const = 0;
	virtual TSharedPtr<ILiveLinkSource> CreateSource(const FString&) const { return {}; }
};
