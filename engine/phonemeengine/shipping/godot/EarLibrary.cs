// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using Godot;

namespace PhonemeEar
{
    /// <summary>Finds the library: beside these files while the game is made, and beside the program afterwards.</summary>
    internal static class EarLibrary
    {
        private const string Folder = "res://addons/phoneme_ear";

        internal static void Find() => NativeLibrary.SetDllImportResolver(Assembly.GetExecutingAssembly(), Load);

        private static IntPtr Load(string name, Assembly assembly, DllImportSearchPath? path)
        {
            if (name != Native.Library)
                return IntPtr.Zero;
            var system = OS.GetName();
            var file = system == "Windows" ? "ear.dll" : system == "macOS" ? "libear.dylib" : "libear.so";
            var arm = RuntimeInformation.ProcessArchitecture == Architecture.Arm64;
            var kind = system == "Windows" ? "windows.x86_64" : system == "macOS" ? "macos" : arm ? "linux.arm64" : "linux.x86_64";
            var program = Path.GetDirectoryName(OS.GetExecutablePath());
            foreach (var place in new[] { program, Path.Combine(program, "..", "Frameworks"), ProjectSettings.GlobalizePath($"{Folder}/bin/{kind}") })
                if (File.Exists(Path.Combine(place, file)) && NativeLibrary.TryLoad(Path.Combine(place, file), out var library))
                    return library;
            return IntPtr.Zero;
        }
    }
}
