/** The editor's page for iframes. Imported and not named by its page: the development server serves this folder alone by address. */
import "../embed/page.css";
import "../embed/page.ts";
