"""What C and C++ keep for themselves, and what the headers of their libraries define.

A macro of a header that a user includes before ours would be put in the place of any name,
so all that the headers of C define are renamed, and what POSIX and Windows add to them. The
tests ask the compilers at hand whether something is missing.
"""

from ..names import Reserved

_KEYWORDS = """
    auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef
    union unsigned void volatile while bool true false complex imaginary I alignas alignof asm
    atomic_cancel atomic_commit atomic_noexcept and and_eq bitand bitor catch char8_t char16_t
    char32_t class co_await co_return co_yield compl concept const_cast consteval constexpr
    constinit decltype delete dynamic_cast explicit export friend mutable namespace new noexcept
    not not_eq nullptr operator or or_eq private protected public reflexpr reinterpret_cast
    requires static_assert static_cast synchronized template this thread_local throw try typeid
    typename typeof typeof_unqual using virtual wchar_t xor xor_eq
"""
_CALLED = """
    sin cos tan asin acos atan atan2 sqrt hypot fabs exp log pow abs fmin fmax memcpy
    size_t ptrdiff_t uint64_t main
"""
_MACROS = """
    NULL NAN INFINITY EOF HUGE MAXFLOAT BUFSIZ RAND_MAX NSIG NZERO NGREG NFDBITS TMP_MAX
    DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS X_TLOSS TRUE FALSE IN OUT OPTIONAL CONST VOID
    errno signgam assert offsetof math_errhandling stdin stdout stderr noreturn kill_dependency
    near far min max small interface pascal cdecl unix linux i386 sun mips sparc vax
    alloca strdupa strndupa conj carg cimag creal cproj setjmp sigsetjmp sigmask isascii toascii
    LITTLE_ENDIAN BIG_ENDIAN PDP_ENDIAN BYTE_ORDER EXIT_SUCCESS EXIT_FAILURE MB_CUR_MAX
    MINSIGSTKSZ MAX_CANON MAX_INPUT PIPE_BUF WORD_BIT LONG_BIT CHAR_BIT P_tmpdir WEOF
    NL_ARGMAX NL_LANGMAX NL_MSGMAX NL_NMAX NL_SETMAX NL_TEXTMAX CLOCKS_PER_SEC
    DECIMAL_DIG TIME_UTC TIMER_ABSTIME TEMP_FAILURE_RETRY
    WCONTINUED WEXITED WNOHANG WNOWAIT WSTOPPED WUNTRACED WEXITSTATUS WIFCONTINUED WIFEXITED
    WIFSIGNALED WIFSTOPPED WSTOPSIG WTERMSIG
    R_OK W_OK X_OK F_OK F_LOCK F_TEST F_TLOCK F_ULOCK L_INCR L_SET L_XTND L_ctermid L_cuserid
    L_tmpnam assert_perror sa_handler sa_sigaction
"""
_ERRORS = """
    E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN EALREADY EAUTH EBADE EBADF EBADFD
    EBADMSG EBADR EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECHILD ECHRNG ECOMM ECONNABORTED
    ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EHWPOISON EDESTADDRREQ EDOM EDOOFUS EDOTDOT
    EDQUOT EEXIST EFAULT EFBIG
    EFTYPE EHOSTDOWN EHOSTUNREACH EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN EISDIR EISNAM
    EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD ELIBEXEC
    ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG ENAVAIL
    ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO ENOBUFS ENOCSI ENODATA ENODEV ENOENT ENOEXEC ENOKEY
    ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG ENOPROTOOPT ENOSPC ENOSR ENOSTR ENOSYS
    ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE ENOTSOCK ENOTSUP ENOTTY ENOTUNIQ
    ENXIO EOPNOTSUPP EOTHER EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROCLIM EPROTO
    EPROTONOSUPPORT EPROTOTYPE ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN
    ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY EUCLEAN
    EUNATCH EUSERS EWOULDBLOCK EXDEV EXFULL
"""
_SIGNALS = """
    SIGABRT SIGALRM SIGBUS SIGCHLD SIGCLD SIGCONT SIGFPE SIGHUP SIGILL SIGINT SIGIO SIGIOT SIGKILL
    SIGPIPE SIGPOLL SIGPROF SIGPWR SIGQUIT SIGRTMAX SIGRTMIN SIGSEGV SIGSTKFLT SIGSTKSZ SIGSTOP
    SIGSYS SIGTERM SIGTRAP SIGTSTP SIGTTIN SIGTTOU SIGURG SIGUSR1 SIGUSR2 SIGVTALRM SIGWINCH
    SIGXCPU SIGXFSZ SIGBREAK SIGEMT SIGINFO SIGLOST SIGUNUSED
"""
_CONSTANTS = """
    M_1_PI M_2_PI M_2_SQRTPI M_E M_LN10 M_LN2 M_LOG10E M_LOG2E M_PI M_PI_2 M_PI_4 M_SQRT1_2 M_SQRT2
    HUGE_VAL HUGE_VAL_ SNAN NAN CMPLX DEC_NAN DEC_INFINITY
"""
_TYPES = "l f f16 f32 f32x f64 f64x f128 L F F16 F32 F32X F64 F64X F128"
_BEGINNINGS = """
    mechc_ MECHC_ Mechc_ FE_ FP_ FPE_ LC_ SIG_ SIGEV_ SI_ SA_ SS_ SEEK_ SEGV_ BUS_ CLD_ ILL_ TRAP_
    POLL_ CLOCK_ STA_ ADJ_ MOD_ REG_ FD_ XATTR_ PTHREAD_ RENAME_ CLOSE_RANGE_ MATH_ FLT_ DBL_ LDBL_
    DEC_ DEC32_ DEC64_ DEC128_ PRIX PRId PRIi PRIo PRIu PRIx SCNX SCNd SCNi SCNo SCNu SCNx si_
    sigev_ INT8_ INT16_ INT32_ INT64_ INTMAX_ UINT8_ UINT16_ UINT32_ UINT64_ UINTMAX_ STDIN_ STDOUT_
    STDERR_
"""
_ENDINGS = ("_MAX", "_MIN", "_WIDTH")
_LINKED = """
    strtok_r strerror_r strerror_l strcoll_l strxfrm_l strcasecmp_l strncasecmp_l strerrordesc_np
    strerrorname_np sigabbrev_np sigdescr_np explicit_bzero va_arg va_copy va_end va_start va_list
    isalnum_l isalpha_l isascii_l isblank_l iscntrl_l isdigit_l isgraph_l islower_l isprint_l
    ispunct_l isspace_l isupper_l isxdigit_l toascii_l tolower_l toupper_l lgamma_r gamma_r
    int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t intmax_t uintmax_t intptr_t uintptr_t
    float_t double_t locale_t max_align_t div_t ldiv_t lldiv_t time_t clock_t wint_t ssize_t off_t
    assoc_laguerre assoc_legendre comp_ellint_1 comp_ellint_2 comp_ellint_3 cyl_bessel_i
    cyl_bessel_j cyl_bessel_k cyl_neumann ellint_1 ellint_2 ellint_3 riemann_zeta sph_bessel
    sph_legendre sph_neumann
"""
_LINKED_BEGINNINGS = """
    lgammaf lgammal fmaximum_ fminimum_ int_fast int_least uint_fast uint_least atomic_ memory_order
"""
RESERVED = Reserved(
    [
        *f"{_KEYWORDS} {_CALLED} {_MACROS} {_ERRORS} {_SIGNALS}".split(),
        *(word + ending for word in _CONSTANTS.split() for ending in ("", *_TYPES.split())),
    ],
    _BEGINNINGS.split(),
    _ENDINGS,
)
"""Keywords of C and C++, the functions called, and the macros of common headers.

What begins with an underscore is reserved too, and no name that is given out does.
"""

LINKED = RESERVED.besides(_LINKED.split(), _LINKED_BEGINNINGS.split())
"""The same, and the functions and types that names at file scope must keep away from."""

_HEADERS = """
    assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal
    stdalign stdarg stdatomic stdbit stdbool stdckdint stddef stdint stdio stdlib stdnoreturn
    string tgmath threads time uchar wchar wctype features endian alloca strings unistd
"""
HEADERS = frozenset(_HEADERS.split())
"""The headers of C, and those of the system that they include, without ``.h``."""
