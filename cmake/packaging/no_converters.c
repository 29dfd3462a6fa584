/* libicuuc for libxml2, which asks ICU for converters of rare encodings: none opens, and libxml2 says that it does not know the
   encoding. coapt reads no XML (DCMTK, which links libxml2, could), and ICU's tables would be a third of the tarball. The names are those
   of Debian 12's ICU 72. */
#include <stddef.h>

enum { FILE_ACCESS_ERROR = 4, UNSUPPORTED_ERROR = 16 }; /* ICU's UErrorCode */

void* ucnv_open_72(const char* name, int* status) {
  (void)name;
  *status = FILE_ACCESS_ERROR;
  return NULL;
}

void ucnv_close_72(void* converter) { (void)converter; }

/* Never called: they take converters. */
void ucnv_convertEx_72(void* target, void* source, char** to, const char* to_end, const char** from, const char* from_end,
                       void* pivot_start, void** pivot_source, void** pivot_target, const void* pivot_end, char reset, char flush,
                       int* status) {
  (void)target, (void)source, (void)to, (void)to_end, (void)from, (void)from_end, (void)pivot_start, (void)pivot_source,
      (void)pivot_target, (void)pivot_end, (void)reset, (void)flush;
  *status = UNSUPPORTED_ERROR;
}
void ucnv_setFromUCallBack_72(void) {}
void ucnv_setToUCallBack_72(void) {}
void UCNV_FROM_U_CALLBACK_STOP_72(void) {}
void UCNV_TO_U_CALLBACK_STOP_72(void) {}
