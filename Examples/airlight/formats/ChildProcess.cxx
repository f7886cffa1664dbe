// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ChildProcess.h"

#include "formats/UserError.h"

#if defined(__unix__) || defined(__APPLE__)

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

namespace airlight
{

// GCC and Clang tell of AddressSanitizer differently.
#if defined(__SANITIZE_ADDRESS__)
#define AIRLIGHT_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define AIRLIGHT_SANITIZED 1
#endif
#endif

namespace
{
constexpr int ExitUserError = 2;
constexpr char UserErrorMark = '\x01'; // parts the UserError's text from what was printed before
constexpr std::size_t MaximumNoise = 1 << 16;

// A damaged header can ask for any amount of memory: more than the machine has cannot be right.
void LimitResources()
{
  const struct rlimit noCore = { 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
#if defined(_SC_PHYS_PAGES) && !defined(AIRLIGHT_SANITIZED) // which reserves terabytes
  const rlim_t memory =
    static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  const struct rlimit limit = { memory, memory };
  setrlimit(RLIMIT_AS, &limit);
#endif
}

// Without destructors: they belong to the parent.
[[noreturn]] void Leave(int code)
{
#if defined(AIRLIGHT_SANITIZED) && defined(SYS_exit_group)
  // _exit() has LeakSanitizer look for leaks, which it cannot in a child of several threads.
  syscall(SYS_exit_group, code);
#endif
  _exit(code);
}

[[noreturn]] void RunChild(const std::function<void()>& task, int pipeEnd)
{
  LimitResources();
  const int null = open("/dev/null", O_WRONLY);
  dup2(null, STDOUT_FILENO);
  dup2(pipeEnd, STDERR_FILENO);
  for (int signal : { SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL })
  {
    std::signal(signal, SIG_DFL);
  }
  int code = EXIT_SUCCESS;
  try
  {
    task();
  }
  catch (const UserError& error)
  {
    std::fprintf(stderr, "%c%s", UserErrorMark, error.what());
    code = ExitUserError;
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(stderr, "%casks for more memory than there is", UserErrorMark);
    code = ExitUserError;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%c%s", UserErrorMark, error.what());
    code = ExitUserError;
  }
  std::fflush(stderr);
  Leave(code);
}

// What the child prints. One that prints without end is reading a header gone wild: it is stopped.
std::string ReadAll(int pipeEnd, pid_t child)
{
  std::string text;
  char buffer[4096];
  ssize_t size = 0;
  while ((size = read(pipeEnd, buffer, sizeof(buffer))) > 0)
  {
    text.append(buffer, static_cast<std::size_t>(size));
    if (text.size() > MaximumNoise)
    {
      kill(child, SIGKILL);
      break;
    }
  }
  return text;
}

std::string GetFirstLine(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of("\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
}

// Some of VTK's readers print their complaints and go on with what they have got.
bool IsComplaint(const std::string& line)
{
  return line.find("rror") != std::string::npos || line.find("nexpected") != std::string::npos;
}

std::string Explain(int status, const std::string& text)
{
  const std::size_t mark = text.find(UserErrorMark);
  if (WIFEXITED(status) && WEXITSTATUS(status) == ExitUserError && mark != std::string::npos)
  {
    return text.substr(mark + 1);
  }
  const std::string line = GetFirstLine(text);
  if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS)
  {
    return IsComplaint(line) ? line : "";
  }
  return "damaged, VTK's reader fails on it" + (line.empty() ? "" : ": " + line);
}
}

//------------------------------------------------------------------------------
void TryInChildProcess(const std::string& fileName, const std::function<void()>& task)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw UserError(fileName + ": no process can be started to read it");
  }
  std::fflush(nullptr); // or the child would print it again
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    RunChild(task, ends[1]);
  }
  close(ends[1]);
  std::string complaint = "no process can be started to read it";
  if (child > 0)
  {
    const std::string text = ReadAll(ends[0], child);
    int status = 0;
    waitpid(child, &status, 0);
    complaint = Explain(status, text);
  }
  close(ends[0]);
  if (!complaint.empty())
  {
    const bool named = complaint.compare(0, fileName.size(), fileName) == 0;
    throw UserError(named ? complaint : fileName + ": " + complaint);
  }
}

}

#else

namespace airlight
{

void TryInChildProcess(const std::string&, const std::function<void()>&) {}

}

#endif
