; The installer for Windows, by Inno Setup: iscc /DVersion=0.9.0 tools\bundle\installer.iss
[Setup]
AppId=PhonemeAnalyser
AppName=PhonemeAnalyser
AppVersion={#Version}
DefaultDirName={autopf}\PhonemeAnalyser
DefaultGroupName=PhonemeAnalyser
PrivilegesRequired=lowest
ChangesAssociations=yes
SourceDir=..\..
OutputDir=build\bundle
OutputBaseFilename=PhonemeAnalyser-{#Version}-windows-setup
LicenseFile=LICENSE
UninstallDisplayIcon={app}\PhonemeAnalyser.exe
Compression=lzma2
SolidCompression=yes

[Files]
Source: "build\bundle\PhonemeAnalyser\*"; DestDir: "{app}"; Flags: recursesubdirs

[Icons]
Name: "{group}\PhonemeAnalyser"; Filename: "{app}\PhonemeAnalyser.exe"

[Registry]
Root: HKA; Subkey: "Software\Classes\.phonemedata"; ValueType: string; ValueData: "PhonemeAnalyser.File"; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\.3dm\OpenWithProgids"; ValueType: string; ValueName: "PhonemeAnalyser.File"; ValueData: ""; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\.3dma\OpenWithProgids"; ValueType: string; ValueName: "PhonemeAnalyser.File"; ValueData: ""; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\.wav\OpenWithProgids"; ValueType: string; ValueName: "PhonemeAnalyser.File"; ValueData: ""; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\.flac\OpenWithProgids"; ValueType: string; ValueName: "PhonemeAnalyser.File"; ValueData: ""; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\PhonemeAnalyser.File"; ValueType: string; ValueData: "PhonemeAnalyser"; Flags: uninsdeletekey
Root: HKA; Subkey: "Software\Classes\PhonemeAnalyser.File\DefaultIcon"; ValueType: string; ValueData: "{app}\PhonemeAnalyser.exe,0"
Root: HKA; Subkey: "Software\Classes\PhonemeAnalyser.File\shell\open\command"; ValueType: string; ValueData: """{app}\PhonemeAnalyser.exe"" ""%1"""
