/// False in the page that `make static` builds: it closes and opens valves itself, and says where it needs coapt-server.
export const HAS_SERVICE = import.meta.env.MODE !== 'static'
