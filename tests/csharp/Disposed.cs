// Calls all that the shipped C# offers on what was disposed of, for tests: Disposed.exe PRESET.
// Says a line for each member: type, member, and the exception that came, or "nothing".

using System;
using System.IO;
using System.Linq;
using System.Reflection;
using PhonemeEar;

public static class Disposed
{
    private static readonly Type[] Kinds = typeof(EarModel).Assembly.GetExportedTypes()
        .Where(type => typeof(IDisposable).IsAssignableFrom(type)).ToArray();

    public static void Main(string[] words)
    {
        var preset = File.ReadAllBytes(words[0]);
        foreach (var kind in Kinds)
        {
            var model = new EarModel(preset);
            var closed = Opened(kind, model);
            closed.Dispose();
            closed.Dispose(); // twice is once
            CallAll("", closed);
            if (kind == typeof(EarModel))
                continue;
            var orphan = Opened(kind, model);
            model.Dispose();
            CallAll("model of ", orphan);
            orphan.Dispose();
        }
    }

    private static IDisposable Opened(Type kind, EarModel model)
    {
        if (kind == typeof(EarModel))
            return model;
        if (kind == typeof(Ear))
            return new Ear(model, 44100);
        if (kind == typeof(Mouth))
            return new Mouth(model, model.FindTable("arkit"));
        throw new NotSupportedException($"{kind.Name}: say here how it is opened");
    }

    private static void CallAll(string what, IDisposable closed)
    {
        const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.DeclaredOnly;
        foreach (var method in closed.GetType().GetMethods(own).Where(method => method.Name != nameof(IDisposable.Dispose)))
            Console.WriteLine($"{what}{closed.GetType().Name} {method.Name} {Outcome(() => Call(method, closed))}");
    }

    private static string Outcome(Action act)
    {
        try
        {
            act();
            return "nothing";
        }
        catch (TargetInvocationException error)
        {
            return error.InnerException.GetType().Name;
        }
    }

    private static void Call(MethodInfo method, object closed) =>
        method.Invoke(closed, method.GetParameters().Select(parameter => Given(parameter.ParameterType)).ToArray());

    private static object Given(Type type)
    {
        if (type == typeof(string))
            return "arkit";
        if (type.IsArray)
            return Array.CreateInstance(type.GetElementType(), 100);
        return Activator.CreateInstance(type.IsByRef ? type.GetElementType() : type);
    }
}
